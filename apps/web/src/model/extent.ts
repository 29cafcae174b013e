// SPDX-License-Identifier: Apache-2.0
import type { Ball, Point3 } from "./placement";

/** What points fill: their box, and a ball around it. */
export interface Extent extends Ball {
  /** Of the box, front to back. */
  readonly depth: number;
}

/** 3 numbers per point. */
export function extentOf(positions: Float32Array): Extent {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    const axis = i % 3;
    const value = positions[i] ?? 0;
    if (value < (low[axis] ?? 0)) low[axis] = value;
    if (value > (high[axis] ?? 0)) high[axis] = value;
  }
  if (positions.length === 0) return { centre: [0, 0, 0], radius: 0, depth: 0 };
  const side = (axis: number): number => (high[axis] ?? 0) - (low[axis] ?? 0);
  const middle = (axis: number): number => ((high[axis] ?? 0) + (low[axis] ?? 0)) / 2;
  const centre: Point3 = [middle(0), middle(1), middle(2)];
  return { centre, radius: Math.hypot(side(0), side(1), side(2)) / 2, depth: side(2) };
}
