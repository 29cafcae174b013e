// SPDX-License-Identifier: Apache-2.0
import type { SaveState } from "../protocol/messages";
import { areSameBytes, joinBytes } from "./bytes";
import type { Description, LineKey } from "./records";
import { ReadBackDiffers, SessionGone, SessionTaken, type SessionTable } from "./session-table";

/** So often a write that the browser has refused is tried again, besides at every append. */
const retryMs = 5000;

/** What goes wrong more often than this in one write will go wrong again. */
const mostAttempts = 4;

/** More lines than this since the last copy of the whole, and as many bytes as it had, ask for another. */
const mostLines = 32;

interface Piece {
  readonly generation: number;
  readonly bytes: Uint8Array;
}

/** What a writer goes on from. */
export interface Earlier {
  readonly created: number;
  readonly holder: string;
  /** The number of the newest generation. */
  readonly newest: number;
  /** To go on from. */
  readonly bytes: Uint8Array;
  /** The newest generation is these bytes, written in one piece. */
  readonly isFresh: boolean;
  readonly description: Description;
}

export interface WriterParts {
  readonly table: SessionTable;
  readonly newId: () => string;
  readonly now: () => number;
  readonly tell: (state: SaveState) => void;
  /** The session goes on under another name. */
  readonly onMoved: (session: string) => void;
}

function isQuota(error: unknown): boolean {
  return error instanceof Error && error.name === "QuotaExceededError";
}

/**
 * Writes one session, in order, one transaction after another; what comes while one is under way goes into the next. The whole
 * newest generation stays in memory, so that it can be written again wherever the stored one was lost.
 */
export class SessionWriter {
  private queue: Piece[] = [];
  private whole: Uint8Array[] = [];
  /** Since its first piece. */
  private addedBytes = 0;
  private newest = -1;
  /** The last generation that is in the database. */
  private stored = { generation: -1, lines: 0 };
  private readonly holder: string;
  private holders: string[];
  private created: number;
  /** Of the database, byte for byte: to begin a generation with these is nothing new. */
  private fresh: Uint8Array | null = null;
  private mustBeginAnew = true;
  private description: Description | null = null;
  private isDescriptionDue = false;
  private isRefused = false;
  private draining: Promise<void> | null = null;
  private retry: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly parts: WriterParts,
    private session: string,
    earlier: Earlier | null,
  ) {
    this.holder = parts.newId();
    this.holders = [this.holder];
    this.created = earlier?.created ?? parts.now();
    if (earlier === null) return;
    const { newest, bytes, isFresh, holder } = earlier;
    this.holders.push(holder);
    this.newest = newest;
    this.whole = [bytes];
    this.stored = { generation: newest, lines: 1 };
    this.fresh = isFresh ? bytes : null;
    this.description = earlier.description;
  }

  append(bytes: Uint8Array): void {
    if (bytes.byteLength === 0) return;
    if (this.mustBeginAnew || this.isCopyDue()) {
      this.begin(joinBytes([...this.whole, bytes]));
      return;
    }
    const own = joinBytes([bytes]);
    this.whole.push(own);
    this.addedBytes += own.byteLength;
    this.put({ generation: this.newest, bytes: own });
  }

  startNew(bytes: Uint8Array): void {
    const isKnown = this.fresh !== null && areSameBytes(this.fresh, bytes);
    if (isKnown) this.say({ kind: "saved", timeMs: this.parts.now() });
    else this.begin(joinBytes([bytes]));
  }

  rename(name: string): void {
    if (name === this.description?.name) return;
    this.describe({ name, picture: this.description?.picture ?? null });
  }

  describe(description: Description): void {
    this.description = description;
    this.isDescriptionDue = true;
    this.wake();
  }

  /** When nothing is under way: all is written, or was refused. */
  async settled(): Promise<void> {
    while (this.draining !== null) await this.draining;
  }

  get isWritten(): boolean {
    return this.queue.length === 0;
  }

  /** When everything is written; never where the browser goes on refusing. */
  async written(): Promise<void> {
    await this.settled();
    while (!this.isWritten) {
      await new Promise((resolve) => setTimeout(resolve, retryMs));
      await this.settled();
    }
  }

  /** Now and then the whole is written again, as a generation of its own: then no damaged line can cost all that was drawn. */
  private isCopyDue(): boolean {
    const firstBytes = this.whole[0]?.byteLength ?? 0;
    return this.whole.length > mostLines && this.addedBytes > firstBytes;
  }

  private begin(bytes: Uint8Array): void {
    this.mustBeginAnew = false;
    this.fresh = null;
    this.newest += 1;
    this.whole = [bytes];
    this.addedBytes = 0;
    this.put({ generation: this.newest, bytes });
  }

  private put(piece: Piece): void {
    this.queue.push(piece);
    if (!this.isRefused) this.say({ kind: "saving" });
    this.wake();
  }

  private say(state: SaveState): void {
    this.isRefused = state.kind === "refused";
    this.parts.tell(state);
  }

  private wake(): void {
    if (this.draining !== null) return;
    clearTimeout(this.retry);
    this.draining = this.drain().finally(() => {
      this.draining = null;
      if (this.isRefused) {
        this.retry = setTimeout(() => {
          this.wake();
        }, retryMs);
      } else if (this.queue.length > 0) this.wake();
    });
  }

  private async drain(): Promise<void> {
    let attempts = 0;
    const wasEmpty = this.queue.length === 0;
    while (this.queue.length > 0) {
      try {
        await this.writeNext();
        attempts = 0;
        // Before anybody hears that all is saved: the name is part of it.
        if (this.isWritten) await this.writeDescription();
      } catch (error) {
        attempts += 1;
        if (attempts < mostAttempts && (await this.isMended(error, attempts))) continue;
        this.say({ kind: "refused", why: isQuota(error) ? "full" : "unavailable" });
        return;
      }
    }
    if (!wasEmpty) this.say({ kind: "saved", timeMs: this.parts.now() });
    await this.writeDescription();
  }

  /** All that waits for one generation goes into one line. */
  private async writeNext(): Promise<void> {
    const generation = this.queue[0]?.generation ?? 0;
    const batch = this.queue.filter((piece) => piece.generation === generation);
    const bytes = joinBytes(batch.map((piece) => piece.bytes));
    const sequence = this.stored.generation === generation ? this.stored.lines : 0;
    const key: LineKey = [this.session, generation, sequence];
    const record = {
      created: this.created,
      changed: this.parts.now(),
      newest: generation,
      lines: sequence + 1,
      holder: this.holder,
    };
    await this.parts.table.addLine(key, bytes, record, this.holders);
    this.holders = [this.holder];
    if (sequence === 0) await this.parts.table.proveAndDropOld(key, bytes);
    this.stored = { generation, lines: sequence + 1 };
    this.queue = this.queue.filter((piece) => !batch.includes(piece));
  }

  /** Whether another attempt makes sense. */
  private async isMended(error: unknown, attempts: number): Promise<boolean> {
    if (isQuota(error)) return attempts === 1 && this.hasFreed();
    if (error instanceof SessionTaken) {
      this.session = this.parts.newId();
      this.holders = [this.holder];
      this.parts.onMoved(this.session);
    } else if (error instanceof ReadBackDiffers) {
      this.newest += 1;
    } else if (!(error instanceof SessionGone)) return false;
    this.queueWhole();
    return true;
  }

  private queueWhole(): void {
    const bytes = joinBytes(this.whole);
    this.whole = [bytes];
    this.addedBytes = 0;
    this.queue = [{ generation: this.newest, bytes }];
    this.stored = { generation: -1, lines: 0 };
    this.isDescriptionDue = this.description !== null;
  }

  /** Room is made of our own copies only; the last good one stays. */
  private hasFreed(): Promise<boolean> {
    return this.parts.table.dropBefore(this.session, this.stored.generation).then(
      () => true,
      () => false,
    );
  }

  /** Comes after the work itself; where there is no room for a picture, the work is as safe without. */
  private async writeDescription(): Promise<void> {
    if (!this.isDescriptionDue || this.description === null || this.stored.generation < 0) return;
    this.isDescriptionDue = false;
    const { description } = this;
    await this.parts.table.describe(this.session, description).catch(() => undefined);
  }
}
