// SPDX-License-Identifier: Apache-2.0

/** A stretch of corners that belong to one part of the model. */
export interface PartRange {
  /** Depth order, 0 at the back. */
  readonly part: number;
  readonly first: number;
  readonly count: number;
}

/** The stretches of a list of one part per corner, 3 corners to a triangle. */
export function partRanges(parts: Float32Array): readonly PartRange[] {
  const ranges: PartRange[] = [];
  let first = 0;
  for (let corner = 3; corner <= parts.length; corner += 3) {
    if (corner < parts.length && parts[corner] === parts[first]) continue;
    ranges.push({ part: parts[first] ?? 0, first, count: corner - first });
    first = corner;
  }
  return ranges;
}
