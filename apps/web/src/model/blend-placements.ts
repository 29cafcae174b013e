// SPDX-License-Identifier: Apache-2.0
import { handedness, placed, scaleOf } from "./placement";
import type { Placement, Point3 } from "./placement";
import { matrixOf, turnBetween, turnOf } from "./turn";
import type { Matrix3 } from "./turn";

const mix = (from: number, to: number, share: number): number => from + (to - from) * share;

/** The placement without its scale and its flip of y: a rotation. */
function rotation(placement: Placement): Matrix3 {
  const scale = scaleOf(placement);
  const at = (row: number, column: number): number =>
    ((row === 1 ? -1 : 1) * (placement[4 * row + column] ?? 0)) / scale;
  return [at(0, 0), at(0, 1), at(0, 2), at(1, 0), at(1, 1), at(1, 2), at(2, 0), at(2, 1), at(2, 2)];
}

/** The matrix given, moved so that it brings `centre` to `target`. */
function anchored(matrix: Matrix3, centre: Point3, target: Point3): Placement {
  const row = (i: 0 | 1 | 2): number[] => {
    const three = matrix.slice(3 * i, 3 * i + 3);
    const offset = three.reduce(
      (sum, value, column) => sum - value * (centre[column] ?? 0),
      target[i],
    );
    return [...three, offset];
  };
  return [...row(0), ...row(1), ...row(2)];
}

/**
 * A placement on the way from one to the other: the centre goes straight, turn and scale change evenly.
 *
 * share: 0 .. 1. Where one of them mirrors the model, no turn leads to the other: it is folded over through its edge.
 */
export function blendPlacements(
  from: Placement,
  to: Placement,
  centre: Point3,
  share: number,
): Placement {
  if (share <= 0) return from;
  if (share >= 1) return to;
  const isTurn = handedness(from) > 0 && handedness(to) > 0;
  if (!isTurn) return from.map((value, i) => mix(value, to[i] ?? 0, share));
  const start = placed(from, centre);
  const end = placed(to, centre);
  const target: Point3 = [
    mix(start[0], end[0], share),
    mix(start[1], end[1], share),
    mix(start[2], end[2], share),
  ];
  const scale = Math.exp(mix(Math.log(scaleOf(from)), Math.log(scaleOf(to)), share));
  const m = matrixOf(turnBetween(turnOf(rotation(from)), turnOf(rotation(to)), share));
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = m;
  const matrix: Matrix3 = [
    scale * xx,
    scale * xy,
    scale * xz,
    -scale * yx,
    -scale * yy,
    -scale * yz,
    scale * zx,
    scale * zy,
    scale * zz,
  ];
  return anchored(matrix, centre, target);
}
