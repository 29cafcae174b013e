// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { matrixOf, turnBetween, turnOf } from "./turn";
import type { Turn } from "./turn";

/** About an axis of length 1. */
function about(x: number, y: number, z: number, angle: number): Turn {
  const s = Math.sin(angle / 2);
  return [Math.cos(angle / 2), s * x, s * y, s * z];
}

const turns: readonly Turn[] = [
  about(0, 1, 0, 0),
  about(0, 1, 0, 1),
  about(1, 0, 0, Math.PI),
  about(0, 1, 0, Math.PI),
  about(0, 0, 1, Math.PI),
  about(0.6, 0.8, 0, 2.9),
];

describe("a turn", () => {
  it.each(turns)("is the same after going through its matrix: %f %f %f %f", (...turn) => {
    const matrix = matrixOf(turn);
    matrixOf(turnOf(matrix)).forEach((value, i) => {
      expect(value).toBeCloseTo(matrix[i] ?? NaN, 12);
    });
  });

  it("leads to another the shorter way round", () => {
    const [w, x, y, z] = about(0, 1, 0, 1);
    const middle = turnBetween(about(0, 1, 0, 0), [-w, -x, -y, -z], 0.5);
    matrixOf(middle).forEach((value, i) => {
      expect(value).toBeCloseTo(matrixOf(about(0, 1, 0, 0.5))[i] ?? NaN, 12);
    });
  });
});
