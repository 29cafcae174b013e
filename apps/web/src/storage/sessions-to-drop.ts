// SPDX-License-Identifier: Apache-2.0
import type { SessionRow } from "../protocol/messages";

const mostSessions = 20;
/** These stay, whatever is held. */
const safeSessions = 5;

/** Which of the sessions, last changed first, are too many: the oldest that nobody holds. */
export function sessionsToDrop(rows: readonly SessionRow[], held: ReadonlySet<string>): string[] {
  const surplus = Math.max(0, rows.length - mostSessions);
  const free = rows.slice(safeSessions).filter(({ id }) => !held.has(id));
  return free.slice(Math.max(0, free.length - surplus)).map(({ id }) => id);
}
