// SPDX-License-Identifier: Apache-2.0
import { Connection } from "./connection";
import { IndexedJournalStore } from "./indexed-journal-store";
import type { JournalStore } from "./journal-store";
import { MemoryJournalStore } from "./memory-journal-store";
import { AskedHolds, LockedHolds, type SessionHolds } from "./session-holds";

/** The second is for when the first is damaged beyond opening, or of a newer version. */
const databaseNames = ["inkflate", "inkflate-2"];

/** 128 random bits; randomUUID is not there in pages that come over plain http. */
function randomId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

function makeHolds(): SessionHolds {
  // Undefined in insecure contexts, whatever the types say.
  const locks = navigator.locks as LockManager | undefined;
  return locks
    ? new LockedHolds(locks)
    : new AskedHolds(new BroadcastChannel("inkflate.sessions"), randomId);
}

/** Opens the store of this browser; where that is refused, one in memory that says so. Never rejects. */
export async function openJournalStore(): Promise<JournalStore> {
  try {
    const connection = await Connection.open(indexedDB, databaseNames);
    return new IndexedJournalStore({
      connection,
      holds: makeHolds(),
      newId: randomId,
      now: Date.now,
    });
  } catch {
    return new MemoryJournalStore(randomId);
  }
}
