// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { dashedPieces } from "./line-dashes";

function pieces(points: number[], widths: number[], dashes: number[]) {
  return dashedPieces(
    Float32Array.from(points),
    Float32Array.from(widths),
    Float32Array.from(dashes),
  ).map((piece) => ({ points: [...piece.points], widths: [...piece.widths] }));
}

describe("dashes", () => {
  it("cut a line where the pattern changes, with the width that it has there", () => {
    expect(pieces([0, 0, 10, 0], [0, 10], [4, 2])).toEqual([
      { points: [0, 0, 4, 0], widths: [0, 4] },
      { points: [6, 0, 10, 0], widths: [6, 10] },
    ]);
  });

  it("go on round corners", () => {
    expect(pieces([0, 0, 4, 0, 4, 10], [2], [6, 100])).toEqual([
      { points: [0, 0, 4, 0, 4, 2], widths: [2, 2, 2] },
    ]);
  });

  it("of length 0 are dots", () => {
    const dots = pieces([0, 0, 10, 0], [3], [0, 4]);
    expect(dots.map((dot) => dot.points.slice(0, 2))).toEqual([
      [0, 0],
      [4, 0],
      [8, 0],
    ]);
    for (const { points } of dots) expect(points.slice(-2)).toEqual(points.slice(0, 2));
  });
});
