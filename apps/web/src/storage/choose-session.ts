// SPDX-License-Identifier: Apache-2.0
import type { SessionRow } from "../protocol/messages";
import { areSameBytes } from "./bytes";

const recentMs = 7 * 24 * 60 * 60 * 1000;

function lookAlike(a: SessionRow, b: SessionRow): boolean {
  const hasPictures = a.picture !== null && b.picture !== null;
  return a.name === b.name && hasPictures && areSameBytes(a.picture, b.picture);
}

function recent(free: readonly SessionRow[], nowMs: number): SessionRow[] {
  return free.filter(({ changedMs }) => nowMs - changedMs <= recentMs);
}

/**
 * Which drawing to go on with, so that a person who comes back finds the paper as it was and is asked nothing. null: a new one.
 *
 * in      own: the session that this tab had before it was loaded again, null: a new tab
 *         free: sessions that no tab holds, last changed first
 */
export function chooseSession(
  own: string | null,
  free: readonly SessionRow[],
  nowMs: number,
): string | null {
  return own ?? recent(free, nowMs)[0]?.id ?? null;
}

/** Whether the person may have meant another one than was chosen, and should be shown them. */
export function hasRivals(own: string | null, free: readonly SessionRow[], nowMs: number): boolean {
  const [newest, ...others] = recent(free, nowMs);
  return own === null && newest !== undefined && others.some((row) => !lookAlike(row, newest));
}
