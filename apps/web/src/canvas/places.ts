// SPDX-License-Identifier: Apache-2.0
import type { AffineNumbers } from "../protocol/scene";

/** CSS px of the view, origin top left; not to be mixed up with px of the canvas, which only the core knows to reckon with. */
export type ScreenPoint = readonly [x: number, y: number] & { readonly brand?: "screen px" };

/** Of what is drawn; empty while left > right. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

export const nowhere: Box = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };

export function isEmpty(box: Box): boolean {
  return !(box.left < box.right && box.top < box.bottom);
}

export function joined(a: Box, b: Box): Box {
  return {
    left: Math.min(a.left, b.left),
    top: Math.min(a.top, b.top),
    right: Math.max(a.right, b.right),
    bottom: Math.max(a.bottom, b.bottom),
  };
}

export function common(a: Box, b: Box): Box {
  return {
    left: Math.max(a.left, b.left),
    top: Math.max(a.top, b.top),
    right: Math.min(a.right, b.right),
    bottom: Math.min(a.bottom, b.bottom),
  };
}

export function grown(box: Box, by: number): Box {
  return {
    left: box.left - by,
    top: box.top - by,
    right: box.right + by,
    bottom: box.bottom + by,
  };
}

export function shifted(box: Box, x: number, y: number): Box {
  return { left: box.left + x, top: box.top + y, right: box.right + x, bottom: box.bottom + y };
}

/** The whole pixels that a box touches. */
export function roundedOut(box: Box): Box {
  return {
    left: Math.floor(box.left),
    top: Math.floor(box.top),
    right: Math.ceil(box.right),
    bottom: Math.ceil(box.bottom),
  };
}

export function area(box: Box): number {
  return isEmpty(box) ? 0 : (box.right - box.left) * (box.bottom - box.top);
}

/** x, y, x, y, ... */
export function boxOf(numbers: Float32Array): Box {
  let { left, top, right, bottom } = nowhere;
  for (let i = 0; i + 1 < numbers.length; i += 2) {
    const x = numbers[i] ?? 0;
    const y = numbers[i + 1] ?? 0;
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  return { left, top, right, bottom };
}

export const unmoved: AffineNumbers = [1, 0, 0, 1, 0, 0];

/** The factor by which lengths grow on average: src/geometry/affine.h. */
export function meanScale(map: AffineNumbers): number {
  return Math.sqrt(Math.abs(map[0] * map[3] - map[1] * map[2]));
}

/** The map followed by a scaling of what comes out. */
export function enlarged(map: AffineNumbers, factor: number): AffineNumbers {
  const [a, b, c, d, e, f] = map;
  return [a * factor, b * factor, c * factor, d * factor, e * factor, f * factor];
}

/** The box around a box that was mapped. */
export function mapped(box: Box, [a, b, c, d, e, f]: AffineNumbers): Box {
  if (box.left > box.right) return nowhere;
  const xs = [a * box.left, a * box.right];
  const xs2 = [c * box.top, c * box.bottom];
  const ys = [b * box.left, b * box.right];
  const ys2 = [d * box.top, d * box.bottom];
  return {
    left: Math.min(...xs) + Math.min(...xs2) + e,
    right: Math.max(...xs) + Math.max(...xs2) + e,
    top: Math.min(...ys) + Math.min(...ys2) + f,
    bottom: Math.max(...ys) + Math.max(...ys2) + f,
  };
}

/** Both maps turn, scale and mirror alike: one can only be shifted against the other. */
export function hasSameForm(one: AffineNumbers, other: AffineNumbers): boolean {
  return [0, 1, 2, 3].every((i) => one[i] === other[i]);
}

/** null: the map leaves nothing of the plane. */
export function inverse([a, b, c, d, e, f]: AffineNumbers): AffineNumbers | null {
  const determinant = a * d - b * c;
  if (determinant === 0) return null;
  const ia = d / determinant;
  const ib = -b / determinant;
  const ic = -c / determinant;
  const id = a / determinant;
  return [ia, ib, ic, id, -(ia * e + ic * f), -(ib * e + id * f)];
}

/** First inner, then outer. */
export function composed(outer: AffineNumbers, inner: AffineNumbers): AffineNumbers {
  const [a, b, c, d, e, f] = outer;
  return [
    a * inner[0] + c * inner[1],
    b * inner[0] + d * inner[1],
    a * inner[2] + c * inner[3],
    b * inner[2] + d * inner[3],
    a * inner[4] + c * inner[5] + e,
    b * inner[4] + d * inner[5] + f,
  ];
}

/** The box around what a map takes into a box. */
export function unmapped(box: Box, map: AffineNumbers): Box {
  const back = inverse(map);
  return back === null ? nowhere : mapped(box, back);
}
