// SPDX-License-Identifier: Apache-2.0
import type { RefObject } from "preact";
import { useEffect } from "preact/hooks";

/** Calls back on Esc, when the hand goes down outside of an element, and when the focus leaves it. */
export function useOutside(
  ref: RefObject<HTMLElement>,
  isActive: boolean,
  leave: () => void,
): void {
  useEffect(() => {
    if (!isActive) return undefined;
    const onEvent = (event: Event) => {
      const isInside = event.target instanceof Node && ref.current?.contains(event.target) === true;
      if (!isInside) leave();
    };
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== "Escape" || event.defaultPrevented) return;
      // It must not drop the selection as well.
      event.stopPropagation();
      leave();
    };
    document.addEventListener("pointerdown", onEvent, true);
    document.addEventListener("focusin", onEvent);
    document.addEventListener("keydown", onKey);
    return () => {
      document.removeEventListener("pointerdown", onEvent, true);
      document.removeEventListener("focusin", onEvent);
      document.removeEventListener("keydown", onKey);
    };
  }, [isActive]);
}
