// SPDX-License-Identifier: Apache-2.0
import type { EngineState, Language } from "../protocol/state";

/** What the core says of itself before it has said anything, so that the page can be drawn at once. */
export function emptyState(language: Language): EngineState {
  return {
    mode: "draw",
    tool: "brush",
    brushPx: 3,
    ink: "#22242b",
    smoothing: 0.5,
    eraserPx: 12,
    bendMode: "body",
    bendBody: 1,
    bendReach: null,
    usualReach: 0.6,
    pins: 0,
    hasPin: false,
    isOverPart: false,
    hasGrid: true,
    isMirrored: false,
    zoom: 1,
    shading: "textured",
    layers: [],
    hasRoughStrokes: false,
    gapPx: null,
    marks: 0,
    hasTemplate: false,
    isBlank: true,
    undo: null,
    redo: null,
    isSaved: true,
    fileName: "drawing",
    language,
    enabled: ["brush", "help_line", "eraser", "mark", "select_tool", "deform", "hand", "mode_draw"],
  };
}
