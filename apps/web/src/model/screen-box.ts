// SPDX-License-Identifier: Apache-2.0
import type { Extent } from "./extent";

/** px, from the lower left as WebGL counts. */
export interface ScreenBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Parts swell while they rise. */
const swollen = 1.1;

/** Where on a picture of this size something of this extent can be seen, and a margin around it. */
export function screenBox(
  toClip: Float32Array,
  extent: Extent,
  picture: { readonly width: number; readonly height: number },
  marginPx: number,
): ScreenBox {
  const m = (row: number, column: number): number => toClip[4 * column + row] ?? 0;
  const [x, y, z] = extent.centre;
  const [dx, dy, dz] = extent.half;
  const span = (row: number, sidePx: number): readonly [first: number, count: number] => {
    const middle = m(row, 0) * x + m(row, 1) * y + m(row, 2) * z + m(row, 3);
    const half =
      swollen * (Math.abs(m(row, 0)) * dx + Math.abs(m(row, 1)) * dy + Math.abs(m(row, 2)) * dz);
    const px = (clip: number): number => ((clip + 1) / 2) * sidePx;
    const within = (place: number): number => Math.min(Math.max(place, 0), sidePx);
    const first = within(Math.floor(px(middle - half) - marginPx));
    return [first, within(Math.ceil(px(middle + half) + marginPx)) - first];
  };
  const [left, width] = span(0, picture.width);
  const [bottom, height] = span(1, picture.height);
  return { x: left, y: bottom, width, height };
}
