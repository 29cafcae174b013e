// SPDX-License-Identifier: Apache-2.0
import type { SaveState, SessionRow } from "../protocol/messages";
import { joinBytes } from "./bytes";
import type { JournalStore, OpenedSession } from "./journal-store";

/** Where the browser allows no storage: keeps the journal as long as the tab lives, and says so. */
export class MemoryJournalStore implements JournalStore {
  private session = "";
  private whole: Uint8Array[] = [];

  onState: (state: SaveState) => void = () => undefined;

  constructor(private readonly newId: () => string) {}

  open(): Promise<OpenedSession> {
    this.session = this.newId();
    this.whole = [];
    this.tell();
    return Promise.resolve({ id: this.session, name: "", generations: [] });
  }

  append(bytes: Uint8Array): void {
    this.whole.push(joinBytes([bytes]));
    this.tell();
  }

  startNew(bytes: Uint8Array): void {
    this.whole = [];
    this.append(bytes);
  }

  rename(): void {
    // Nobody will ask for it.
  }

  describe(): void {
    // Nobody will list it.
  }

  list(): Promise<SessionRow[]> {
    return Promise.resolve([]);
  }

  forget(): Promise<void> {
    return Promise.resolve();
  }

  raw(session: string): Promise<Uint8Array> {
    return Promise.resolve(joinBytes(session === this.session ? this.whole : []));
  }

  private tell(): void {
    this.onState({ kind: "refused", why: "unavailable" });
  }
}
