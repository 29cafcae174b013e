// SPDX-License-Identifier: Apache-2.0
import type { Ball, Point3 } from "./placement";

/** What points fill: their box, and a ball around it. */
export interface Extent extends Ball {
  /** Half the sides of the box. */
  readonly half: Point3;
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
  if (positions.length === 0) return { centre: [0, 0, 0], radius: 0, half: [0, 0, 0] };
  const middle = (axis: number): number => ((high[axis] ?? 0) + (low[axis] ?? 0)) / 2;
  const side = (axis: number): number => ((high[axis] ?? 0) - (low[axis] ?? 0)) / 2;
  const half: Point3 = [side(0), side(1), side(2)];
  return { centre: [middle(0), middle(1), middle(2)], radius: Math.hypot(...half), half };
}
