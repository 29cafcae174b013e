// SPDX-License-Identifier: Apache-2.0
import { useEffect } from "preact/hooks";
import type { RefObject } from "preact";

/** Calls back when the hand goes down outside of an element, or the focus leaves it. */
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
    document.addEventListener("pointerdown", onEvent, true);
    document.addEventListener("focusin", onEvent);
    return () => {
      document.removeEventListener("pointerdown", onEvent, true);
      document.removeEventListener("focusin", onEvent);
    };
  }, [isActive]);
}
