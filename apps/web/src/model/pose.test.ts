// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { extentOf } from "./extent";
import { risingPose, standingPose } from "./pose";
import { riseMs } from "./rise";

const size = { width: 1000, height: 800 };
const way = {
  onPaper: [0.5, 0, 0, 300, 0, -0.5, 0, 200, 0, 0, 0.001, 0],
  toView: [0, 0, -2, 500, 0, -2, 0, 400, 2, 0, 0, 0],
};
const extent = extentOf(Float32Array.of(-30, -20, -10, 30, 20, 10, 0, 0, 0));

describe("a pose", () => {
  it("lies flat on the paper at first, parts upon each other in their order", () => {
    const pose = risingPose(way, extent, 3, size, 0);
    const parts = [0, 1, 2].map((part) => pose.parts?.(part));
    expect(pose.share).toBe(0);
    expect(parts.map((part) => part?.inflation)).toEqual([0, 0, 0]);
    const lifts = parts.map((part) => part?.liftPx ?? NaN);
    expect(lifts[1]).toBeGreaterThan(lifts[0] ?? NaN);
    expect(lifts[2]).toBeGreaterThan(lifts[1] ?? NaN);
  });

  it("stands where the view has it in the end", () => {
    const pose = risingPose(way, extent, 3, size, riseMs(3));
    const standing = standingPose(way, extent, size);
    [0, 1, 3, 4, 5, 7, 12, 13, 15].forEach((i) => {
      expect(pose.toClip[i]).toBeCloseTo(standing.toClip[i] ?? NaN, 6);
    });
    for (const part of [0, 1, 2]) {
      expect(pose.parts?.(part).inflation).toBeCloseTo(1, 12);
      expect(pose.parts?.(part).liftPx).toBeCloseTo(0, 9);
    }
  });

  it("has all lifted parts between the near and the far end", () => {
    const pose = risingPose(way, extent, 40, size, 0);
    const lift = pose.parts?.(39).liftPx ?? NaN;
    const depth = (z: number): number => (pose.toClip[10] ?? 0) * z + (pose.toClip[14] ?? 0);
    for (const z of [-10, 10, 10 + lift]) expect(Math.abs(depth(z))).toBeLessThanOrEqual(1);
  });
});

describe("an extent", () => {
  it("has its middle in the middle of the box and reaches its corners", () => {
    expect(extent.centre).toEqual([0, 0, 0]);
    expect(extent.radius).toBeCloseTo(Math.hypot(30, 20, 10), 12);
    expect(extent.half).toEqual([30, 20, 10]);
  });

  it("of nothing is nothing", () => {
    expect(extentOf(new Float32Array())).toEqual({ centre: [0, 0, 0], radius: 0, half: [0, 0, 0] });
  });
});
