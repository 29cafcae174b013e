// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { isWithinLimits, widthsAt } from "./line-widths";

function line(widths: number[], leastPx: number, mostPx: number, dashes: number[] = []) {
  return {
    widths: Float32Array.from(widths),
    dashes: Float32Array.from(dashes),
    leastPx,
    mostPx,
  };
}

describe("widths of lines", () => {
  it("grow with the scale between their limits", () => {
    expect([...widthsAt(line([4, 8], 2, 100), 3).widths]).toEqual([4, 8]);
    expect(isWithinLimits(line([4, 8], 2, 100), 3)).toBe(true);
  });

  it("are no less on the screen than the least", () => {
    const { widths } = widthsAt(line([1, 8], 2, 100), 0.5);
    expect([...widths].map((width) => width * 0.5)).toEqual([2, 4]);
    expect(isWithinLimits(line([1, 8], 2, 100), 0.5)).toBe(false);
  });

  it("are no more on the screen than the most", () => {
    const { widths } = widthsAt(line([3, 1], 0, 5), 4);
    expect([...widths].map((width) => width * 4)).toEqual([5, 4]);
  });

  it("become one where all are the same", () => {
    expect(widthsAt(line([3, 3, 3], 0, Infinity), 1).widths).toHaveLength(1);
    expect(widthsAt(line([0.1, 0.2, 0.3], 2, Infinity), 1).widths).toHaveLength(1);
  });

  it("take dashes along by the change of the widest", () => {
    const { dashes } = widthsAt(line([3], 2.5, 5, [0, 6]), 5);
    expect([...dashes].map((dash) => dash * 5)).toEqual([0, 10]);
  });

  it("of nothing leave dashes as they are", () => {
    expect([...widthsAt(line([0], 0, Infinity, [4, 4]), 2).dashes]).toEqual([4, 4]);
  });
});
