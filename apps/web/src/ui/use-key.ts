// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef } from "preact/hooks";

/** A key of the page, wherever the focus is: none of the core's table. */
export function useKey(key: string, onPress: () => void): void {
  const press = useRef(onPress);
  press.current = onPress;
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.key === key && !event.defaultPrevented) press.current();
    };
    document.addEventListener("keydown", onKey);
    return () => {
      document.removeEventListener("keydown", onKey);
    };
  }, [key]);
}
