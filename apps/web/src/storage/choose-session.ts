// SPDX-License-Identifier: Apache-2.0
import type { SessionRow } from "../protocol/messages";
import { areSameBytes } from "./bytes";

const recentMs = 7 * 24 * 60 * 60 * 1000;

export interface SessionChoice {
  /** null: begin a new drawing. */
  readonly session: string | null;
  /** There are others that the person may have meant. */
  readonly isPanelOffered: boolean;
}

function lookAlike(a: SessionRow, b: SessionRow): boolean {
  const hasPictures = a.picture !== null && b.picture !== null;
  return a.name === b.name && hasPictures && areSameBytes(a.picture, b.picture);
}

/**
 * Which drawing to go on with, so that a person who comes back finds the paper as it was and is asked nothing.
 *
 * in      own: the session that this tab had before it was loaded again, null: a new tab
 *         free: sessions that no tab holds, last changed first
 */
export function chooseSession(
  own: string | null,
  free: readonly SessionRow[],
  nowMs: number,
): SessionChoice {
  if (own !== null) return { session: own, isPanelOffered: false };
  const [newest, ...others] = free.filter(({ changedMs }) => nowMs - changedMs <= recentMs);
  if (!newest) return { session: null, isPanelOffered: false };
  return { session: newest.id, isPanelOffered: others.some((row) => !lookAlike(row, newest)) };
}
