// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";
import type { ModelUpdate } from "../protocol/scene";
import type { Studio } from "../studio/studio";

function isSeenAnew(before: ModelUpdate | null, now: ModelUpdate | null): boolean {
  if (before === null || before.id !== now?.id) return false;
  return now.toView.some((value, index) => value !== before.toView[index]);
}

/** Whether the same model has been seen from another side. */
export function useModelTurned(studio: Studio): boolean {
  const [isTurned, setIsTurned] = useState(false);
  useEffect(() => {
    let before: ModelUpdate | null = null;
    return studio.onFrame(({ scene }) => {
      if (scene === null) return;
      if (isSeenAnew(before, scene.model)) setIsTurned(true);
      before = scene.model;
    });
  }, [studio]);
  return isTurned;
}
