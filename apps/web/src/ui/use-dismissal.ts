// SPDX-License-Identifier: Apache-2.0
import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

/** What opens panels closes them too: a press on it is no press outside. */
const openers = "[aria-expanded], [aria-haspopup]";

/** Takes an Esc that nobody inside has taken. */
function freeEscape(close: () => void): (event: KeyboardEvent) => void {
  return (event) => {
    if (event.key !== "Escape" || event.defaultPrevented) return;
    // The Esc that closes this must neither drop the selection nor close what lies below.
    event.stopPropagation();
    event.preventDefault();
    close();
  };
}

/** Closes on Esc and on a press outside. Whoever has taken the Esc inside stops it there. */
export function useDismissal(root: RefObject<HTMLElement>, onClose: () => void): void {
  const close = useRef(onClose);
  close.current = onClose;

  useEffect(() => {
    const onKey = freeEscape(() => {
      close.current();
    });
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

/** Calls back on Esc, when the hand goes down outside of an element, and when the focus leaves it: for what stands in a row of other buttons. */
export function useOutside(
  ref: RefObject<HTMLElement>,
  isActive: boolean,
  leave: () => void,
): void {
  const close = useRef(leave);
  close.current = leave;

  useEffect(() => {
    if (!isActive) return undefined;
    const onEvent = (event: Event) => {
      const isInside = event.target instanceof Node && ref.current?.contains(event.target) === true;
      if (!isInside) close.current();
    };
    const onKey = freeEscape(() => {
      close.current();
    });
    document.addEventListener("pointerdown", onEvent, true);
    document.addEventListener("focusin", onEvent);
    document.addEventListener("keydown", onKey);
    return () => {
      document.removeEventListener("pointerdown", onEvent, true);
      document.removeEventListener("focusin", onEvent);
      document.removeEventListener("keydown", onKey);
    };
  }, [ref, isActive]);
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
