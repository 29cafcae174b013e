// SPDX-License-Identifier: Apache-2.0
import type { EngineState } from "../protocol/state";

/** What a first drawing goes through, in this order. */
export const hintSteps = ["draw", "simplify", "inflate", "turn"] as const;
export type HintStep = (typeof hintSteps)[number];

/** What the person has done so far: how many of the steps. */
export type HintProgress = 0 | 1 | 2 | 3 | 4;

export interface HintFacts {
  readonly state: Pick<EngineState, "hasRoughStrokes" | "layers" | "mode">;
  /** The model has been turned. */
  readonly isTurned: boolean;
}

function stepsSeen({ state, isTurned }: HintFacts): HintProgress {
  const hasParts = state.layers.length > 0;
  const isInflated = hasParts && state.mode !== "draw";
  if (isInflated) return isTurned ? 4 : 3;
  if (hasParts) return 2;
  return state.hasRoughStrokes ? 1 : 0;
}

/** Only what the person does counts; what they have done once is not explained again. */
export function advanceHints(progress: HintProgress, facts: HintFacts): HintProgress {
  const seen = stepsSeen(facts);
  return seen > progress ? seen : progress;
}

/** The step that is explained now; null: the next one cannot be done as things are, or there is none. */
export function hintToShow(progress: HintProgress, { state }: HintFacts): HintStep | null {
  const next = hintSteps.at(progress);
  switch (next) {
    case undefined:
      return null;
    case "draw":
      return next;
    case "simplify":
      return state.hasRoughStrokes ? next : null;
    case "inflate":
      return state.layers.length > 0 && !state.hasRoughStrokes ? next : null;
    case "turn":
      return state.mode === "draw" ? null : next;
  }
}

type BendFacts = Pick<
  EngineState,
  "mode" | "tool" | "isBlank" | "pins" | "undo" | "hasRoughStrokes" | "layers"
>;

/** Deform is in the hand, and there is something on the paper: what is said is about that. */
export function isBending({ mode, tool, isBlank }: BendFacts): boolean {
  return mode === "draw" && tool === "deform" && !isBlank;
}

/**
 * What is said when Deform is first chosen and there is something to bend; once it has been bent or pinned, it is known. Of a sketch
 * with nothing but rough strokes each line would bend by itself, and come off the others.
 */
export function bendHint(facts: BendFacts): "show" | "simplify" | "wait" | "known" {
  const { hasRoughStrokes, layers, undo, pins } = facts;
  if (!isBending(facts)) return "wait";
  if (hasRoughStrokes && layers.length === 0) return "simplify";
  return undo === "deform" || pins > 0 ? "known" : "show";
}
