// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { evenScale, ratioScale } from "./scales";

describe.each([
  ["even", evenScale(0.5, 100)],
  ["ratio", ratioScale(0.5, 100)],
])("an %s scale", (_name, scale) => {
  it("reaches both ends exactly", () => {
    expect(scale.toValue(0)).toBe(0.5);
    expect(scale.toValue(100)).toBe(100);
  });

  it("keeps the slider inside for values outside", () => {
    expect(scale.toPosition(0.01)).toBe(0);
    expect(scale.toPosition(1000)).toBeCloseTo(100, 9);
  });

  it("never goes back on the way up", () => {
    const values = Array.from({ length: 101 }, (_, position) => scale.toValue(position));
    expect(values).toEqual([...values].sort((a, b) => a - b));
  });

  it("comes back to where it was put, within a step", () => {
    for (const position of [0, 17, 50, 83, 100]) {
      expect(Math.abs(scale.toPosition(scale.toValue(position)) - position)).toBeLessThan(2);
    }
  });
});

describe("a ratio scale of small values", () => {
  const scale = ratioScale(0.003, 1);

  it("tells each position from the next", () => {
    const values = Array.from({ length: 101 }, (_, position) => scale.toValue(position));
    expect(values[0]).toBe(0.003);
    expect(values[100]).toBe(1);
    // Two digits: where they are coarsest, two steps may be one.
    expect(new Set(values).size).toBeGreaterThan(90);
  });
});
