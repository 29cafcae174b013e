// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import {
  leastThickness,
  mostThickness,
  stepOf,
  thicknessAt,
  thicknessSteps,
} from "./thickness-scale";

describe("the thickness slider", () => {
  it("goes from the least to the most that the core allows", () => {
    expect(thicknessAt(0)).toBe(leastThickness);
    expect(thicknessAt(thicknessSteps)).toBe(mostThickness);
  });

  it("stays where it was put", () => {
    for (let step = 0; step <= thicknessSteps; step += 10) {
      expect(Math.abs(stepOf(thicknessAt(step)) - step)).toBeLessThanOrEqual(1);
    }
  });

  it("gets thicker with every step that can be told apart", () => {
    for (let step = 2; step <= thicknessSteps; step += 2) {
      expect(thicknessAt(step)).toBeGreaterThan(thicknessAt(step - 2));
    }
  });

  it("takes what lies outside for the end", () => {
    expect(stepOf(0)).toBe(0);
    expect(stepOf(1000)).toBe(thicknessSteps);
  });
});
