// SPDX-License-Identifier: Apache-2.0
import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

/** What opens panels closes them too: a press on it is no press outside. */
const openers = "[aria-expanded], [aria-haspopup]";

/** Closes on Esc and on a press outside. Whoever has taken the Esc inside stops it there. */
export function useDismissal(root: RefObject<HTMLElement>, onClose: () => void): void {
  const close = useRef(onClose);
  close.current = onClose;

  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== "Escape" || event.defaultPrevented) return;
      // The Esc that closes a panel must not drop the selection as well.
      event.stopPropagation();
      event.preventDefault();
      close.current();
    };
    const onPress = (event: PointerEvent) => {
      const target = event.target;
      if (!(target instanceof Element)) return;
      if (root.current?.contains(target) === true || target.closest(openers) !== null) return;
      close.current();
    };
    document.addEventListener("keydown", onKey);
    document.addEventListener("pointerdown", onPress, { capture: true });
    return () => {
      document.removeEventListener("keydown", onKey);
      document.removeEventListener("pointerdown", onPress, { capture: true });
    };
  }, [root]);
}

/** Takes the focus in at once, for keys that follow, and, when it goes, gives it back to what had it. */
export function useBorrowedFocus(root: RefObject<HTMLElement>): void {
  useLayoutEffect(() => {
    const opener = document.activeElement;
    const panel = root.current;
    const first = panel?.querySelector<HTMLElement>("[data-first-focus]") ?? panel;
    first?.focus({ preventScroll: true });
    return () => {
      const active = document.activeElement;
      // Who has moved on by themselves is not called back.
      const isLost = active === document.body || panel?.contains(active) === true;
      if (isLost && opener instanceof HTMLElement && opener.isConnected) opener.focus();
    };
  }, [root]);
}
