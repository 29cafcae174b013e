// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "./actions.generated";

/** What surrounds the canvas shows: src/editor/engine.h, EngineState. */

export type Mode = "draw" | "inflate" | "animate";
export type Tool = "brush" | "help_line" | "eraser" | "mark" | "deform" | "select" | "hand";
export type BendMode = "body" | "wire";
export type Shading = "matcap" | "textured" | "lines";
export type Language = "en" | "cs";

export interface LayerRow {
  readonly id: number;
  readonly name: string;
  /** 0.1 .. 32 */
  readonly thickness: number;
  /** "#rrggbb"; null: the default. */
  readonly fill: string | null;
  readonly isHidden: boolean;
  readonly isLocked: boolean;
  /** Its lines are being edited. */
  readonly isOpen: boolean;
  readonly isSelected: boolean;
  /** Changes when the layer looks different: the key of its thumbnail. */
  readonly look: number;
}

export interface EngineState {
  readonly mode: Mode;
  readonly tool: Tool;
  /** Canvas px. */
  readonly brushPx: number;
  /** "#rrggbb" */
  readonly ink: string;
  /** 0 .. 1 */
  readonly smoothing: number;
  /** px of the screen. */
  readonly eraserPx: number;
  readonly bendMode: BendMode;
  /** 0.003 .. 1: how stiff the inside is beside the line. */
  readonly bendBody: number;
  /** How far a drag reaches, as a share of the part, 0.02 .. 1; 1: the whole part; null: as the part is held. */
  readonly bendReach: number | null;
  /** What null means for the part that is held or meant now. */
  readonly usualReach: number;
  /** A pin is selected. */
  readonly hasPin: boolean;
  /** The pointer is over something that the tool would take. */
  readonly isOverPart: boolean;
  readonly hasGrid: boolean;
  readonly isMirrored: boolean;
  /** px of the screen for one of the canvas. */
  readonly zoom: number;
  readonly shading: Shading;
  /** Front to back, as a list shows them. */
  readonly layers: readonly LayerRow[];
  readonly hasRoughStrokes: boolean;
  /** Largest gap that is closed, canvas px; null: as simplify finds best. */
  readonly gapPx: number | null;
  /** How many marks there are. */
  readonly marks: number;
  /** How many pins the parts that are seen have, to be bent by. */
  readonly pins: number;
  readonly hasTemplate: boolean;
  /** Nothing drawn, no layer, no template. */
  readonly isBlank: boolean;
  /** The action that undo takes back; null: nothing. */
  readonly undo: ActionName | null;
  readonly redo: ActionName | null;
  /** Nothing has changed since the last save to a file. */
  readonly isSaved: boolean;
  /** Without extension. */
  readonly fileName: string;
  readonly language: Language;
  /** Actions that would do something now. */
  readonly enabled: readonly ActionName[];
}

export type Menu = "file" | "edit" | "view" | "tool" | "part" | "model" | "help";

/** One row of the action table, sent once when the core is ready. */
export interface ActionRow {
  readonly name: ActionName;
  readonly menu: Menu;
  readonly labels: Readonly<Record<Language, string>>;
  /** "Ctrl+Shift+Z", the first is shown. */
  readonly chords: readonly string[];
  readonly argument: "none" | "number" | "text" | "colour" | "place" | "choice";
  readonly choices: readonly string[];
}
