// SPDX-License-Identifier: Apache-2.0
import type { SaveState, SessionRow } from "../protocol/messages";

/** One journal of a session, whole or as much of it as could be read. */
export interface Generation {
  readonly number: number;
  /** Up to the first piece that is damaged or missing. */
  readonly bytes: Uint8Array;
  /** Something was damaged or missing. */
  readonly isTorn: boolean;
}

export interface OpenedSession {
  readonly id: string;
  /** What the drawing was called last; "": nobody knows. */
  readonly name: string;
  /**
   * Newest first, but a torn one behind an older one that knows more; empty: a new session. The first that the core can read is the
   * one to go on with; what is appended goes on from the first.
   */
  readonly generations: readonly Generation[];
}

/**
 * Keeps the journals of drawings on this device, so that nothing is lost when the tab, the browser or the machine goes.
 *
 * A session is one drawing in one tab; nobody else writes to it while this store holds it. Writes are queued and never throw: what
 * cannot be written is told through onState, and the drawing goes on in memory.
 */
export interface JournalStore {
  /** Takes a session over, or begins a new one when it is null, held by another tab, or not there. */
  open(session: string | null): Promise<OpenedSession>;
  /** Appends to the newest generation of the open session. */
  append(bytes: Uint8Array): void;
  /** Begins a generation with these bytes; the ones before are kept, up to a few. */
  startNew(bytes: Uint8Array): void;
  /** What the drawing is called: kept at once, for a drawing that is taken up again. Nothing when it is called so already. */
  rename(name: string): void;
  /** What the list of sessions shows. */
  describe(name: string, picture: Uint8Array | null): void;
  /** Sessions that no tab holds, last changed first. */
  list(): Promise<SessionRow[]>;
  forget(session: string): Promise<void>;
  /** All bytes of a session as they are, for a person to keep. */
  raw(session: string): Promise<Uint8Array>;
  /** Called whenever the safety of the work changes. */
  onState: (state: SaveState) => void;
}
