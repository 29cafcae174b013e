// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { cursorLook, type CursorSetting } from "./cursor-look";

const setting: CursorSetting = {
  state: { mode: "draw", tool: "brush", brushPx: 6, eraserPx: 12, isOverPart: false },
  zoom: 3,
  isSpaceHeld: false,
  isDown: false,
};

describe("the cursor", () => {
  it("is a ring as large as the brush on the paper", () => {
    expect(cursorLook(setting)).toEqual({ system: "none", ringPx: 18 });
  });

  it("of a small brush has a cross, so that it can be found", () => {
    expect(cursorLook({ ...setting, zoom: 0.5 })).toEqual({ system: "crosshair", ringPx: 3 });
  });

  it("of the eraser has its size on the screen, whatever the zoom", () => {
    const state = { ...setting.state, tool: "eraser" } as const;
    expect(cursorLook({ ...setting, state }).ringPx).toBe(24);
  });

  it("is a hand that grabs with the hand, with Space, and around the model", () => {
    const hand = { ...setting.state, tool: "hand" } as const;
    const model = { ...setting.state, mode: "inflate" } as const;
    for (const each of [{ state: hand }, { isSpaceHeld: true }, { state: model }]) {
      expect(cursorLook({ ...setting, ...each }).system).toBe("grab");
      expect(cursorLook({ ...setting, ...each, isDown: true }).system).toBe("grabbing");
    }
  });

  it("takes hold with Deform of what it is over, and of nothing else", () => {
    const away = { ...setting.state, tool: "deform" } as const;
    const over = { ...away, isOverPart: true } as const;
    expect(cursorLook({ ...setting, state: away }).system).toBe("default");
    expect(cursorLook({ ...setting, state: over }).system).toBe("grab");
    expect(cursorLook({ ...setting, state: over, isDown: true }).system).toBe("grabbing");
  });
});
