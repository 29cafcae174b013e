// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";
import type { FileOut } from "../protocol/messages";
import type { EngineState } from "../protocol/state";
import type { Studio } from "../studio/studio";

/** Going through the formats with the arrow keys makes none of those that are passed. */
const settleMs = 150;

export type Making =
  | { readonly kind: "making" }
  | { readonly kind: "made"; readonly files: readonly FileOut[] }
  | { readonly kind: "failed" };

/** Changes when an export would become another one. */
function lookOf(state: EngineState): string {
  const { layers, undo, redo, mode, shading, fileName } = state;
  const looks = layers.map(({ id, look, name, isHidden }) => [id, look, name, isHidden]);
  return JSON.stringify([looks, undo, redo, mode, shading, fileName]);
}

/** How the model is turned; a picture of it shows that. */
function useTurn(studio: Studio): string {
  const [turn, setTurn] = useState("");
  useEffect(
    () =>
      studio.onFrame(({ scene }) => {
        if (scene !== null) setTurn(scene.model?.toView.join(" ") ?? "");
      }),
    [studio],
  );
  return turn;
}

/** Makes the files of a format, and anew when the drawing changes: what is shown is what will be saved. */
export function useExport(studio: Studio, extension: string): Making {
  const [making, setMaking] = useState<Making>({ kind: "making" });
  const look = lookOf(studio.state.value);
  const turn = useTurn(studio);
  const pictureTurn = extension === "png" ? turn : "";

  useEffect(() => {
    let isWanted = true;
    const show = (next: Making) => {
      if (isWanted) setMaking(next);
    };
    setMaking({ kind: "making" });
    const timer = setTimeout(() => {
      studio.exportAs(extension).then(
        (files) => {
          show(files.length > 0 ? { kind: "made", files } : { kind: "failed" });
        },
        () => {
          show({ kind: "failed" });
        },
      );
    }, settleMs);
    return () => {
      isWanted = false;
      clearTimeout(timer);
    };
  }, [studio, extension, look, pictureTurn]);

  return making;
}
