// SPDX-License-Identifier: Apache-2.0
import type { EngineState } from "../protocol/state";

/** What the pointer looks like. */
export interface CursorLook {
  /** As the CSS property cursor takes it. */
  readonly system: "none" | "crosshair" | "default" | "grab" | "grabbing";
  /** A ring as large as what would be drawn or erased, px of the screen; null: none. */
  readonly ringPx: number | null;
}

export interface CursorSetting {
  readonly state: Pick<EngineState, "mode" | "tool" | "brushPx" | "eraserPx" | "isOverPart">;
  /** px of the screen for one of the canvas. */
  readonly zoom: number;
  readonly isSpaceHeld: boolean;
  readonly isDown: boolean;
}

/** A smaller ring would hardly be found: a cross shows where it is. */
const leastRingAlonePx = 8;

function ring(diameterPx: number): CursorLook {
  return { system: diameterPx < leastRingAlonePx ? "crosshair" : "none", ringPx: diameterPx };
}

export function cursorLook({ state, zoom, isSpaceHeld, isDown }: CursorSetting): CursorLook {
  const isHand = isSpaceHeld || state.mode !== "draw" || state.tool === "hand";
  if (isHand) return { system: isDown ? "grabbing" : "grab", ringPx: null };
  switch (state.tool) {
    case "brush":
    case "help_line":
      return ring(state.brushPx * zoom);
    case "eraser":
      return ring(2 * state.eraserPx);
    case "mark":
      return { system: "crosshair", ringPx: null };
    case "select":
      return { system: "default", ringPx: null };
    case "deform":
      if (!state.isOverPart) return { system: "default", ringPx: null };
      return { system: isDown ? "grabbing" : "grab", ringPx: null };
  }
}
