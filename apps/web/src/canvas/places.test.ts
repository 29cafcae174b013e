// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { mapped, meanScale, nowhere, unmapped } from "./places";

const box = { left: 1, top: 2, right: 3, bottom: 5 };

describe("boxes", () => {
  it("come back through a map", () => {
    const back = unmapped(mapped(box, [-2, 0, 0, 2, 7, -3]), [-2, 0, 0, 2, 7, -3]);
    expect(back).toEqual(box);
  });

  it("of a mirrored map keep their left side left", () => {
    expect(mapped(box, [-1, 0, 0, 1, 0, 0])).toEqual({ left: -3, top: 2, right: -1, bottom: 5 });
  });

  it("of nothing stay nothing, and a map onto a line has none", () => {
    expect(mapped(nowhere, [2, 0, 0, 2, 1, 1])).toEqual(nowhere);
    expect(unmapped(box, [1, 1, 1, 1, 0, 0])).toEqual(nowhere);
  });

  it("grow by the mean scale, mirrored or not", () => {
    expect(meanScale([-2, 0, 0, 8, 5, 5])).toBe(4);
  });
});
