// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import type { PointerInput } from "../protocol/events";
import { WetLines } from "./wet-lines";
import { WetPen, wetPoint, type PenSetting } from "./wet-pen";

const setting: PenSetting = {
  state: { mode: "draw", tool: "brush", brushPx: 4, ink: "#102030" },
  zoom: 2,
  isSpaceHeld: false,
};

const base: PointerInput = {
  type: "pointer",
  action: "press",
  kind: "mouse",
  id: 1,
  button: "primary",
  x: 0,
  y: 0,
  pressure: 0.5,
  timeS: 1,
  modifiers: { isShift: false, isCtrl: false, isAlt: false },
};

/** What is drawn after these inputs. */
function tails(inputs: Partial<PointerInput>[], changed: Partial<PenSetting> = {}) {
  const lines = new WetLines();
  const pen = new WetPen(lines);
  inputs.forEach((input, i) => {
    pen.hear({ ...base, ...input }, i + 1, { ...setting, ...changed });
  });
  return lines.tails();
}

const pressed = (changed: Partial<PenSetting>) => tails([{}], changed).length;
const finger: Partial<PointerInput> = { kind: "touch", id: 7 };

describe("a pen with wet ink", () => {
  it("draws in the ink's colour, as wide as the brush on the screen", () => {
    expect(tails([{}])[0]).toMatchObject({
      look: { colour: 0xff302010, widthPx: 8, isDashed: false },
      points: [{ widthPx: 8 }],
    });
  });

  it("draws thinner where it presses less, never thinner than the core does", () => {
    const look = { colour: 0, widthPx: 10, isDashed: false };
    expect(wetPoint({ ...base, kind: "pen", pressure: 0 }, look).widthPx).toBeCloseTo(4);
    expect(wetPoint({ ...base, kind: "pen", pressure: 0.5 }, look).widthPx).toBeCloseTo(7);
    expect(wetPoint(base, { ...look, widthPx: 0.1 }).widthPx).toBe(0.75);
  });

  it("keeps its width when it is lifted", () => {
    const [tail] = tails([
      { kind: "pen", pressure: 1 },
      { kind: "pen", pressure: 0, action: "release", x: 9 },
    ]);
    expect(tail?.points.map((point) => point.widthPx)).toEqual([8, 8]);
  });

  it("draws help lines dashed and what is far pale", () => {
    const [tail] = tails([{ button: "secondary" }], {
      state: { ...setting.state, tool: "help_line" },
    });
    expect(tail?.look).toMatchObject({ colour: 0x737d8a1f, isDashed: true });
  });

  it("draws nothing with other tools, in other modes, or while Space is held", () => {
    expect(pressed({ state: { ...setting.state, tool: "eraser" } })).toBe(0);
    expect(pressed({ state: { ...setting.state, mode: "inflate" } })).toBe(0);
    expect(pressed({ isSpaceHeld: true })).toBe(0);
  });

  it("draws nothing with the middle button, a pen's other end, or a straight line", () => {
    expect(tails([{ button: "middle" }])).toEqual([]);
    expect(tails([{ kind: "pen", button: "eraser" }])).toEqual([]);
    expect(
      tails([{}, { action: "move", modifiers: { ...base.modifiers, isShift: true } }]),
    ).toEqual([]);
  });

  it("draws with one finger and stops at once when a second comes", () => {
    expect(tails([finger])).toHaveLength(1);
    expect(tails([finger, { ...finger, id: 8 }])).toEqual([]);
  });

  it("waits after a pinch until all fingers are up", () => {
    const up = { ...finger, action: "release" } as const;
    const pinch = [finger, { ...finger, id: 8 }, { ...up, id: 8 }];
    expect(tails([...pinch, { ...finger, id: 9 }])).toEqual([]);
    expect(tails([...pinch, up, { ...finger, id: 9 }])).toHaveLength(1);
  });

  it("leaves fingers to the core where a pen draws or has just been near", () => {
    const pen = { kind: "pen", id: 2 } as const;
    const up = { ...pen, action: "release" } as const;
    expect(tails([pen, up, { ...finger, timeS: 60 }])).toHaveLength(1);
    expect(
      tails([
        { ...pen, action: "move" },
        { ...finger, timeS: 1.2 },
      ]),
    ).toEqual([]);
    expect(
      tails([
        { ...pen, action: "move" },
        { ...finger, timeS: 9 },
      ]),
    ).toHaveLength(1);
  });

  it("drops the line of a palm when the pen comes", () => {
    expect(tails([finger, { kind: "pen", id: 2, action: "move" }])).toEqual([]);
  });

  it("drops a line that is cancelled", () => {
    expect(tails([{}, { action: "cancel" }])).toEqual([]);
  });
});
