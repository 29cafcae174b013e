// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import type { LayerRow } from "../protocol/state";
import {
  advanceHints,
  bendHint,
  hintToShow,
  type HintFacts,
  type HintProgress,
} from "./hint-steps";

const part: LayerRow = {
  id: 1,
  name: "",
  thickness: 2,
  fill: null,
  isHidden: false,
  isLocked: false,
  isOpen: false,
  isSelected: false,
  look: 1,
};
const blank: HintFacts = {
  state: { hasRoughStrokes: false, layers: [], mode: "draw" },
  isTurned: false,
};
const drawn: HintFacts = { ...blank, state: { ...blank.state, hasRoughStrokes: true } };
const simplified: HintFacts = { ...blank, state: { ...blank.state, layers: [part] } };
const inflated: HintFacts = { ...blank, state: { ...simplified.state, mode: "inflate" } };
const turned: HintFacts = { ...inflated, isTurned: true };

/** What is shown after each of these. */
function shownAlong(way: readonly HintFacts[]): unknown[] {
  let progress: HintProgress = 0;
  return way.map((facts) => {
    progress = advanceHints(progress, facts);
    return hintToShow(progress, facts);
  });
}

describe("first-start hints", () => {
  it("follow the first minute step by step", () => {
    expect(shownAlong([blank, drawn, simplified, inflated, turned])).toEqual([
      "draw",
      "simplify",
      "inflate",
      "turn",
      null,
    ]);
  });

  it("skip what an example has brought along", () => {
    expect(shownAlong([blank, simplified])).toEqual(["draw", "inflate"]);
  });

  it("say nothing of a step that cannot be done now", () => {
    expect(shownAlong([drawn, blank])).toEqual(["simplify", null]);
    expect(shownAlong([inflated, simplified])).toEqual(["turn", null]);
  });

  it("wait for the end of more lines before they speak of inflating", () => {
    const both: HintFacts = { ...drawn, state: { ...drawn.state, layers: [part] } };
    expect(shownAlong([simplified, both, simplified])).toEqual(["inflate", null, "inflate"]);
  });

  it("do not explain again what has been done once", () => {
    expect(shownAlong([turned, blank, drawn])).toEqual([null, null, null]);
  });

  it("do not take an empty model for an inflated one", () => {
    const empty: HintFacts = { ...blank, state: { ...blank.state, mode: "inflate" } };
    expect(advanceHints(0, empty)).toBe(0);
  });
});

describe("the hint of Deform", () => {
  const bendable = {
    mode: "draw",
    tool: "deform",
    isBlank: false,
    pins: 0,
    undo: "simplify",
    hasRoughStrokes: false,
    layers: [part],
  } as const;

  it("is shown when there is something to bend", () => {
    expect(bendHint(bendable)).toBe("show");
    expect(bendHint({ ...bendable, isBlank: true })).toBe("wait");
    expect(bendHint({ ...bendable, tool: "select" })).toBe("wait");
    expect(bendHint({ ...bendable, mode: "inflate" })).toBe("wait");
  });

  it("says to simplify first where each line would bend by itself, also after one was bent", () => {
    const sketch = { ...bendable, hasRoughStrokes: true, layers: [] };
    expect(bendHint(sketch)).toBe("simplify");
    expect(bendHint({ ...sketch, undo: "deform" })).toBe("simplify");
    expect(bendHint({ ...sketch, tool: "brush" })).toBe("wait");
    expect(bendHint({ ...sketch, layers: [part] })).toBe("show");
  });

  it("is known to who has bent or pinned", () => {
    expect(bendHint({ ...bendable, undo: "deform" })).toBe("known");
    expect(bendHint({ ...bendable, pins: 1 })).toBe("known");
  });
});
