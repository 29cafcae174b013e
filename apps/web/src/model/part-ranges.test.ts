// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { partRanges } from "./part-ranges";

const triangles = (...parts: number[]): Float32Array =>
  Float32Array.from(parts.flatMap((part) => [part, part, part]));

describe("the stretches of parts", () => {
  it("cover all corners, each part in one piece where its triangles stand together", () => {
    expect(partRanges(triangles(0, 0, 1, 4))).toEqual([
      { part: 0, first: 0, count: 6 },
      { part: 1, first: 6, count: 3 },
      { part: 4, first: 9, count: 3 },
    ]);
  });

  it("come back to a part that goes on later", () => {
    expect(partRanges(triangles(1, 0, 1)).map((range) => range.part)).toEqual([1, 0, 1]);
  });

  it("are none without triangles", () => {
    expect(partRanges(triangles())).toEqual([]);
  });
});
