// SPDX-License-Identifier: Apache-2.0

/** 3 x 4, row by row, from model px to the view's px, as ModelUpdate has it. */
export type Placement = readonly number[];

export type Point3 = readonly [x: number, y: number, z: number];

/** A sphere around all that is drawn, in model px. */
export interface Ball {
  readonly centre: Point3;
  readonly radius: number;
}

export interface ViewSize {
  readonly width: number;
  readonly height: number;
}

const entry = (placement: Placement, row: number, column: number): number =>
  placement[4 * row + column] ?? 0;

/** Where a placement brings a point. */
export function placed(placement: Placement, [x, y, z]: Point3): Point3 {
  const row = (i: number): number =>
    entry(placement, i, 0) * x +
    entry(placement, i, 1) * y +
    entry(placement, i, 2) * z +
    entry(placement, i, 3);
  return [row(0), row(1), row(2)];
}

/** Positive where the view shows the model as it is, negative where mirrored. */
export function handedness(placement: Placement): number {
  const m = (row: number, column: number): number => entry(placement, row, column);
  const determinant =
    m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
    m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
    m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
  // The view's y runs down, the model's up.
  return -determinant;
}

/** A flat placement with heights to the same scale as the rest: ModelUpdate.onPaper presses them down, here each part does. */
export function raised(onPaper: Placement): Placement {
  const m = (row: number, column: number): number => entry(onPaper, row, column);
  const scale = Math.sqrt(Math.abs(m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0)));
  return [m(0, 0), m(0, 1), 0, m(0, 3), m(1, 0), m(1, 1), 0, m(1, 3), 0, 0, scale, 0];
}

/** How many px of the view one of the model is. */
export function scaleOf(placement: Placement): number {
  return Math.cbrt(Math.abs(handedness(placement)));
}

/** Half of the depth, in px of the view, that has to fit between the near and the far end. */
export function depthReach(placement: Placement, ball: Ball): number {
  return Math.max(scaleOf(placement) * ball.radius, 1e-6);
}

/** From model px to clip space, column by column as WebGL takes it. Rays are parallel, so any depth can be made to fit. */
export function clipMatrix(placement: Placement, ball: Ball, size: ViewSize): Float32Array {
  const middle = placed(placement, ball.centre)[2];
  const reach = depthReach(placement, ball);
  const rows: readonly (readonly [scale: number, offset: number])[] = [
    [2 / size.width, -1],
    [-2 / size.height, 1],
    [-1 / reach, middle / reach],
  ];
  const clip = new Float32Array(16);
  rows.forEach(([scale, offset], row) => {
    for (let column = 0; column < 4; ++column) {
      clip[4 * column + row] = scale * entry(placement, row, column) + (column === 3 ? offset : 0);
    }
  });
  clip[15] = 1;
  return clip;
}

/** Turns the model's normals to the viewer's: x to the right, y up, z towards the viewer; column by column. */
export function normalMatrix(placement: Placement): Float32Array {
  const scale = scaleOf(placement) || 1;
  const turn = new Float32Array(9);
  for (let row = 0; row < 3; ++row) {
    const sign = row === 1 ? -1 : 1;
    for (let column = 0; column < 3; ++column) {
      turn[3 * column + row] = (sign * entry(placement, row, column)) / scale;
    }
  }
  return turn;
}
