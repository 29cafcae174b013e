// SPDX-License-Identifier: Apache-2.0

/** What makes one list of chunks another. */
export interface SheetChanges<T> {
  readonly removed: readonly T[];
  /** Under something that stays. */
  readonly inserted: readonly T[];
  /** That stay, back to front, and what is inserted between them. */
  readonly below: readonly T[];
  /** Over all that stays: can be painted over it. */
  readonly appended: readonly T[];
}

/** Compares the things themselves: another core may give an id again. null: they have changed their order. */
export function sheetChanges<T>(before: readonly T[], after: readonly T[]): SheetChanges<T> | null {
  const old = new Set(before);
  const now = new Set(after);
  const kept = before.filter((chunk) => now.has(chunk));
  const keptAfter = after.filter((chunk) => old.has(chunk));
  if (kept.some((chunk, i) => chunk !== keptAfter[i])) return null;
  const end = after.findLastIndex((chunk) => old.has(chunk)) + 1;
  const below = after.slice(0, end);
  return {
    removed: before.filter((chunk) => !now.has(chunk)),
    inserted: below.filter((chunk) => !old.has(chunk)),
    below,
    appended: after.slice(end),
  };
}
