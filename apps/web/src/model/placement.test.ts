// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { clipMatrix, handedness, normalMatrix, raised, scaleOf } from "./placement";
import type { Placement, Point3 } from "./placement";

const size = { width: 1000, height: 800 };
/** Three times as large, its origin at (500, 400); y down. */
const front: Placement = [3, 0, 0, 500, 0, -3, 0, 400, 0, 0, 3, 7];
/** Seen from the model's right side. */
const side: Placement = [0, 0, -3, 500, 0, -3, 0, 400, 3, 0, 0, 0];
const ball = { centre: [0, 0, 10], radius: 50 } as const;

function clipped(placement: Placement, [x, y, z]: Point3): readonly number[] {
  const m = clipMatrix(placement, ball, size);
  const row = (i: number): number =>
    (m[i] ?? 0) * x + (m[4 + i] ?? 0) * y + (m[8 + i] ?? 0) * z + (m[12 + i] ?? 0);
  return [row(0), row(1), row(2), row(3)];
}

describe("the clip matrix", () => {
  it("brings the view's middle to the middle and its corners to the corners", () => {
    expect(clipped(front, [0, 0, 0]).slice(0, 2)).toEqual([0, 0]);
    const [x, y] = clipped(front, [-500 / 3, 400 / 3, 0]);
    expect(x).toBeCloseTo(-1, 6);
    expect(y).toBeCloseTo(1, 6);
  });

  it("has all of the ball between the near and the far end, the nearest in front", () => {
    expect(clipped(front, [0, 0, 60])[2]).toBeCloseTo(-1, 6);
    expect(clipped(front, [0, 0, -40])[2]).toBeCloseTo(1, 6);
    expect(clipped(side, [50, 0, 10])[2]).toBeCloseTo(-1, 6);
  });

  it("keeps parallel rays parallel", () => {
    expect(clipped(side, [12, 34, 56])[3]).toBe(1);
  });

  it("is finite for a model without extent", () => {
    const dot = { centre: [0, 0, 0], radius: 0 } as const;
    expect([...clipMatrix(front, dot, size)].every(Number.isFinite)).toBe(true);
  });
});

describe("a placement", () => {
  it("knows its scale", () => {
    expect(scaleOf(front)).toBeCloseTo(3, 12);
    expect(scaleOf(side)).toBeCloseTo(3, 12);
  });

  it("that is pressed flat gets heights to its own scale", () => {
    const pressed: Placement = [0, 2, 0, 300, 2, 0, 0, 200, 0, 0, 0.001, 0];
    expect(raised(pressed)).toEqual([0, 2, 0, 300, 2, 0, 0, 200, 0, 0, 2, 0]);
    expect(scaleOf(raised(pressed))).toBeCloseTo(2, 12);
  });

  it("knows whether it mirrors", () => {
    expect(handedness(side)).toBeGreaterThan(0);
    expect(handedness([-3, 0, 0, 500, 0, -3, 0, 400, 0, 0, 3, 7])).toBeLessThan(0);
  });

  it("shows normals with y up, whatever its scale", () => {
    const expected = [1, 0, 0, 0, 1, 0, 0, 0, 1];
    normalMatrix(front).forEach((value, i) => {
      expect(value).toBeCloseTo(expected[i] ?? NaN, 6);
    });
  });

  it("shows what looks to the model's right to a viewer who stands there", () => {
    const [x, y, z] = normalMatrix(side);
    expect(x).toBeCloseTo(0, 6);
    expect(y).toBeCloseTo(0, 6);
    expect(z).toBeCloseTo(1, 6);
  });
});
