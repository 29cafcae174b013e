// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";

/** Whether a pointer is down on the paper: then all that only talks steps aside. */
export function useCanvasPress(): boolean {
  const [isPressed, setIsPressed] = useState(false);
  useEffect(() => {
    const onPress = (event: PointerEvent) => {
      // Its canvases let pointers through to the stage.
      const { target } = event;
      if (target instanceof Element && target.closest(".stage") !== null) setIsPressed(true);
    };
    const onRelease = () => {
      setIsPressed(false);
    };
    const releases = ["pointerup", "pointercancel", "blur"] as const;
    addEventListener("pointerdown", onPress, { capture: true });
    for (const name of releases) addEventListener(name, onRelease, { capture: true });
    return () => {
      removeEventListener("pointerdown", onPress, { capture: true });
      for (const name of releases) removeEventListener(name, onRelease, { capture: true });
    };
  }, []);
  return isPressed;
}
