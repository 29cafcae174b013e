// SPDX-License-Identifier: Apache-2.0
import "fake-indexeddb/auto";
import { IDBFactory } from "fake-indexeddb";
import type { SaveState } from "../protocol/messages";
import { Connection } from "./connection";
import { IndexedJournalStore } from "./indexed-journal-store";
import type { SessionHolds } from "./session-holds";

/** What tests of the store share: a browser with several tabs, in memory. */

/** The locks of all tabs of one browser. */
export class FakeHolds implements SessionHolds {
  private readonly mine = new Set<string>();

  constructor(private readonly all: Set<string>) {}

  take(session: string): Promise<boolean> {
    const isFree = this.mine.has(session) || !this.all.has(session);
    if (isFree) this.mine.add(session);
    if (isFree) this.all.add(session);
    return Promise.resolve(isFree);
  }

  release(session: string): void {
    if (this.mine.delete(session)) this.all.delete(session);
  }

  held(): Promise<ReadonlySet<string>> {
    return Promise.resolve(this.all);
  }

  /** As when the tab goes. */
  releaseAll(): void {
    for (const session of this.mine) this.all.delete(session);
    this.mine.clear();
  }
}

export interface Tab {
  readonly store: IndexedJournalStore;
  readonly states: SaveState[];
  readonly connection: Connection;
  /** The tab is gone; what is under way may still arrive, what waits does not, and nothing more is told. */
  close(): void;
}

export class FakeBrowser {
  readonly factory = new IDBFactory();
  nowMs = 1_000_000;
  private readonly held = new Set<string>();
  private ids = 0;

  async tab(holds = new FakeHolds(this.held)): Promise<Tab> {
    const connection = await Connection.open(this.factory, ["inkflate"]);
    const store = new IndexedJournalStore({
      connection,
      holds,
      newId: () => `id-${++this.ids}`,
      now: () => ++this.nowMs,
    });
    const states: SaveState[] = [];
    store.onState = (state) => states.push(state);
    return {
      store,
      states,
      connection,
      close: () => {
        connection.write = () => new Promise(() => undefined);
        store.onState = () => undefined;
        holds.releaseAll();
      },
    };
  }
}

export function bytesOf(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}

export function textOf(bytes: Uint8Array | undefined): string | null {
  return bytes ? new TextDecoder().decode(bytes) : null;
}

/** When the store has said, after its last write has begun, that all is saved, or that it is not. */
export async function untilTold(tab: Tab): Promise<SaveState> {
  for (;;) {
    const last = tab.states.at(-1);
    if (last && last.kind !== "saving") return last;
    await new Promise((resolve) => setTimeout(resolve, 0));
  }
}

/** The same numbers for the same seed: mulberry32. */
export function numbersFrom(seed: number): (below: number) => number {
  let state = seed >>> 0;
  return (below) => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) % below;
  };
}
