// SPDX-License-Identifier: Apache-2.0
import type { SaveState, SessionRow } from "../protocol/messages";
import type { Connection } from "./connection";
import type { JournalStore, OpenedSession } from "./journal-store";
import { assembleGenerations, rawBytes } from "./records";
import type { SessionHolds } from "./session-holds";
import { readRows, readSession, type FoundSession } from "./session-reader";
import { sessionsToDrop } from "./sessions-to-drop";
import { SessionTable } from "./session-table";
import { SessionWriter, type Earlier } from "./session-writer";

/** The tab before it was loaded again may take a moment to let go. */
const patienceMs = 1000;

export interface StoreParts {
  readonly connection: Connection;
  readonly holds: SessionHolds;
  readonly newId: () => string;
  readonly now: () => number;
}

/** Keeps journals in IndexedDB. */
export class IndexedJournalStore implements JournalStore {
  private readonly table: SessionTable;
  private writer: SessionWriter | null = null;
  private session: string | null = null;

  onState: (state: SaveState) => void = () => undefined;

  constructor(private readonly parts: StoreParts) {
    this.table = new SessionTable(parts.connection);
  }

  async open(session: string | null): Promise<OpenedSession> {
    await this.leave();
    const found = session === null ? null : await this.take(session);
    void this.dropSurplus();
    const opened =
      session !== null && found !== null ? this.goOn(session, found) : await this.beginNew();
    // Whatever there is now came from the database.
    this.onState({ kind: "saved", timeMs: this.parts.now() });
    return opened;
  }

  append(bytes: Uint8Array): void {
    this.writer?.append(bytes);
  }

  startNew(bytes: Uint8Array): void {
    this.writer?.startNew(bytes);
  }

  rename(name: string): void {
    this.writer?.rename(name);
  }

  describe(name: string, picture: Uint8Array | null): void {
    this.writer?.describe({ name, picture });
  }

  async list(): Promise<SessionRow[]> {
    try {
      const [rows, held] = await Promise.all([
        readRows(this.parts.connection),
        this.parts.holds.held(),
      ]);
      return rows.filter(({ id }) => id !== this.session && !held.has(id));
    } catch {
      return [];
    }
  }

  async forget(session: string): Promise<void> {
    if (session === this.session || !(await this.parts.holds.take(session, 0))) return;
    await this.table.forget(session).catch(() => undefined);
    this.parts.holds.release(session);
  }

  async raw(session: string): Promise<Uint8Array> {
    if (session === this.session) await this.writer?.settled();
    return readSession(this.parts.connection, session).then(
      ({ lines }) => rawBytes(lines),
      () => new Uint8Array(0),
    );
  }

  /** What could not be written yet is tried further; until then the session stays held. */
  private async leave(): Promise<void> {
    const { writer } = this;
    if (writer === null) return;
    await writer.settled();
    const { session } = this;
    this.writer = null;
    this.session = null;
    if (session === null) return;
    if (writer.isWritten) this.parts.holds.release(session);
    else void this.releaseLater(writer, session);
  }

  private async releaseLater(writer: SessionWriter, session: string): Promise<void> {
    await writer.written();
    if (this.session !== session) this.parts.holds.release(session);
  }

  /** null: another tab has it, or there is nothing in it. */
  private async take(session: string): Promise<FoundSession | null> {
    if (!(await this.parts.holds.take(session, patienceMs))) return null;
    const found = await readSession(this.parts.connection, session).catch(() => null);
    if (found !== null && found.lines.length > 0) return found;
    this.parts.holds.release(session);
    return null;
  }

  private async beginNew(): Promise<OpenedSession> {
    const id = this.parts.newId();
    await this.parts.holds.take(id, 0);
    this.begin(id, null);
    return { id, name: "", generations: [] };
  }

  private goOn(session: string, { lines, record, description }: FoundSession): OpenedSession {
    const generations = assembleGenerations(lines, record);
    const best = generations[0];
    const newest = Math.max(...generations.map(({ number }) => number));
    const isOfOneLine = lines.filter((line) => line.key[1] === newest).length === 1;
    const earlier = best && {
      created: record?.created ?? this.parts.now(),
      holder: record?.holder ?? "",
      newest,
      bytes: best.bytes,
      isFresh: isOfOneLine && best.number === newest && !best.isTorn,
      description,
    };
    this.begin(session, earlier ?? null);
    return { id: session, name: description.name, generations };
  }

  private begin(session: string, earlier: Earlier | null): void {
    this.session = session;
    const writer = new SessionWriter(
      {
        table: this.table,
        newId: this.parts.newId,
        now: this.parts.now,
        tell: (state) => {
          if (this.writer === writer) this.onState(state);
        },
        onMoved: (moved) => {
          if (this.writer !== writer) return;
          if (this.session !== null) this.parts.holds.release(this.session);
          this.session = moved;
          void this.parts.holds.take(moved, 0);
        },
      },
      session,
      earlier,
    );
    this.writer = writer;
  }

  private async dropSurplus(): Promise<void> {
    try {
      const rows = await readRows(this.parts.connection);
      const held = await this.parts.holds.held();
      for (const id of sessionsToDrop(rows, held)) await this.forget(id);
    } catch {
      // They are dropped another time.
    }
  }
}
