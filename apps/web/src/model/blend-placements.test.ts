// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { blendPlacements } from "./blend-placements";
import { handedness, placed, scaleOf } from "./placement";
import type { Placement, Point3 } from "./placement";

/** As the core makes it: turned about the model's y axis, larger, y down, moved. */
function seen(turn: number, scale: number, x: number, y: number): Placement {
  const [c, s] = [scale * Math.cos(turn), scale * Math.sin(turn)];
  return [c, 0, -s, x, 0, -scale, 0, y, s, 0, c, 0];
}

const centre: Point3 = [10, -20, 5];
const flat = seen(0, 0.5, 300, 200);
const turned = seen(0.7, 2, 500, 400);
const behind = seen(Math.PI, 2, 500, 400);
const mirrored: Placement = [-0.5, 0, 0, 300, 0, -0.5, 0, 200, 0, 0, 0.5, 0];

const expectClose = (found: readonly number[], expected: readonly number[]): void => {
  found.forEach((value, i) => {
    expect(value).toBeCloseTo(expected[i] ?? NaN, 9);
  });
};

describe("placements on the way between two", () => {
  it("are the two themselves at its ends", () => {
    expectClose(blendPlacements(flat, turned, centre, 0), flat);
    expectClose(blendPlacements(flat, turned, centre, 1), turned);
  });

  it("come to the ends without a jump", () => {
    const before = blendPlacements(flat, turned, centre, 1e-12);
    expectClose(before, flat);
    expectClose(blendPlacements(flat, turned, centre, 1 - 1e-12), turned);
  });

  it("turn evenly", () => {
    const middle = blendPlacements(seen(0.2, 1, 0, 0), seen(1, 1, 0, 0), [0, 0, 0], 0.5);
    expectClose(middle, seen(0.6, 1, 0, 0));
  });

  it.each([{ end: turned }, { end: behind }])(
    "keep the model's shape, from behind too",
    ({ end }) => {
      for (const share of [0.1, 0.5, 0.9]) {
        const between = blendPlacements(flat, end, centre, share);
        const scale = scaleOf(between);
        const [o, x, y, z] = [
          [0, 0, 0],
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, 1],
        ].map((point) => placed(between, point as unknown as Point3));
        if (!o || !x || !y || !z) throw new Error("four points");
        const length = (p: Point3): number => Math.hypot(p[0] - o[0], p[1] - o[1], p[2] - o[2]);
        for (const point of [x, y, z]) expect(length(point)).toBeCloseTo(scale, 9);
        expect(handedness(between)).toBeGreaterThan(0);
      }
    },
  );

  it("bring the centre along a straight line", () => {
    const [from, to] = [placed(flat, centre), placed(turned, centre)];
    const between = placed(blendPlacements(flat, turned, centre, 0.25), centre);
    expectClose(
      between,
      from.map((value, i) => value + ((to[i] ?? 0) - value) * 0.25),
    );
  });

  it("fold a mirrored drawing over, as no turn leads to the model", () => {
    expect(handedness(blendPlacements(mirrored, turned, centre, 0.05))).toBeLessThan(0);
    expect(handedness(blendPlacements(mirrored, turned, centre, 0.95))).toBeGreaterThan(0);
  });
});
