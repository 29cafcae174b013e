// SPDX-License-Identifier: Apache-2.0

/** A turn in space as a quaternion of length 1. */
export type Turn = readonly [w: number, x: number, y: number, z: number];

/** 3 x 3, row by row. */
export type Matrix3 = readonly [
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
];

/** The turn that a rotation matrix does. source: Shepperd 1978: divides by the largest of the four. */
export function turnOf(m: Matrix3): Turn {
  const [xx, xy, xz, yx, yy, yz, zx, zy, zz] = m;
  const squares = [1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz];
  const largest = squares.indexOf(Math.max(...squares));
  const four = 2 * Math.sqrt(squares[largest] ?? 1);
  switch (largest) {
    case 0:
      return [four / 4, (zy - yz) / four, (xz - zx) / four, (yx - xy) / four];
    case 1:
      return [(zy - yz) / four, four / 4, (xy + yx) / four, (xz + zx) / four];
    case 2:
      return [(xz - zx) / four, (xy + yx) / four, four / 4, (yz + zy) / four];
    default:
      return [(yx - xy) / four, (xz + zx) / four, (yz + zy) / four, four / 4];
  }
}

export function matrixOf([w, x, y, z]: Turn): Matrix3 {
  return [
    1 - 2 * (y * y + z * z),
    2 * (x * y - w * z),
    2 * (x * z + w * y),
    2 * (x * y + w * z),
    1 - 2 * (x * x + z * z),
    2 * (y * z - w * x),
    2 * (x * z - w * y),
    2 * (y * z + w * x),
    1 - 2 * (x * x + y * y),
  ];
}

/** From one turn to another at an even pace, the shorter way round. source: Shoemake 1985 */
export function turnBetween(from: Turn, to: Turn, share: number): Turn {
  const dot = from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + from[3] * to[3];
  const angle = Math.acos(Math.min(Math.abs(dot), 1));
  // So small an angle has no sine to divide by, and a straight line will do.
  const isSmall = angle < 1e-4;
  const before = isSmall ? 1 - share : Math.sin((1 - share) * angle) / Math.sin(angle);
  const after = (isSmall ? share : Math.sin(share * angle) / Math.sin(angle)) * (dot < 0 ? -1 : 1);
  const mix = (i: 0 | 1 | 2 | 3): number => before * from[i] + after * to[i];
  return [mix(0), mix(1), mix(2), mix(3)];
}
