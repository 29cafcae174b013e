// SPDX-License-Identifier: Apache-2.0

/** Where a row that is dragged would fall: before the row of this index; the number of rows: after the last. */
export function gapAt(middles: readonly number[], y: number): number {
  const next = middles.findIndex((middle) => y < middle);
  return next === -1 ? middles.length : next;
}

/**
 * The place, counted from the back as the core counts, of the row `from` once it has fallen into a gap of a list that has
 * the nearest part on top; null: it is there already.
 */
export function placeFromBack(count: number, from: number, gap: number): number | null {
  const row = gap > from ? gap - 1 : gap;
  if (row === from || row < 0 || row >= count) return null;
  return count - 1 - row;
}

/** The gap into which a row falls that is moved by one; null: it is at the end. */
export function neighbouringGap(
  count: number,
  from: number,
  towards: "nearer" | "farther",
): number | null {
  const gap = towards === "nearer" ? from - 1 : from + 2;
  return gap < 0 || gap > count ? null : gap;
}
