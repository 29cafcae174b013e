// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test, vi } from "vitest";
import { noEdges } from "../protocol/events";
import type { FromWorker } from "../protocol/messages";
import { MemoryJournalStore } from "../storage/memory-journal-store";
import { CoreWorker } from "./core-worker";
import type { CoreEngine } from "./engine";
import type { EngineChanges } from "./engine-changes";

const changes: EngineChanges = {
  isSceneChanged: false,
  isDocumentChanged: false,
  isStateChanged: false,
  messages: [],
  files: [],
  requests: [],
  journal: new Uint8Array(),
  isJournalNew: false,
  isRecoveredWhole: true,
};

/** An engine that settles in so many rounds after each event; keeps what it was asked to do. */
class SettlingEngine {
  readonly done: string[] = [];
  /** Called in the midst of the first round. */
  onFirstWork = () => undefined as unknown;
  private rounds = 0;

  handle(): void {
    this.done.push("event");
    this.rounds = 4;
  }

  hasWork(): boolean {
    return this.rounds > 0;
  }

  work(): void {
    if (!this.done.includes("work")) this.onFirstWork();
    this.done.push("work");
    --this.rounds;
  }

  takeChanges(): EngineChanges {
    return changes;
  }

  scene(): null {
    return null;
  }

  state(): { fileName: string } {
    return { fileName: "cat" };
  }
}

const move = { type: "resize", width: 1, height: 1, edges: noEdges } as const;

function started() {
  const engine = new SettlingEngine();
  const posted: FromWorker[] = [];
  const post = (message: FromWorker) => posted.push(message);
  const worker = new CoreWorker(
    engine as unknown as CoreEngine,
    new MemoryJournalStore(() => "session"),
    post,
  );
  return { engine, posted, worker };
}

/** When a frame has said, since so many were posted, that nothing more will come. */
function rest(posted: readonly FromWorker[], since: number): Promise<void> {
  return vi.waitFor(
    () => {
      const isAtRest = posted.slice(since).some((each) => each.kind === "frame" && each.isAtRest);
      expect(isAtRest).toBe(true);
    },
    { timeout: 4000, interval: 5 },
  );
}

/** More turns of the event loop than all the work of the engine above takes. */
async function turnsOfTheLoop(): Promise<void> {
  for (let turn = 0; turn < 20; ++turn) await new Promise((resolve) => setTimeout(resolve, 0));
}

describe("work that can wait", () => {
  test("is done a round at a time, each shown by a frame, and then ends", async () => {
    const { engine, posted, worker } = started();
    await rest(posted, 0);
    posted.length = 0;
    worker.take({ kind: "events", events: [move], sequence: 1 });
    await rest(posted, 0);
    expect(engine.done).toEqual(["event", "work", "work", "work", "work"]);
    const frames = posted.filter(({ kind }) => kind === "frame");
    expect(frames).toHaveLength(5);
    const areAtRest = frames.map((frame) => frame.kind === "frame" && frame.isAtRest);
    expect(areAtRest).toEqual([false, false, false, false, true]);
    await turnsOfTheLoop();
    expect(posted.filter(({ kind }) => kind === "frame")).toHaveLength(5);
  });

  test("gives way to what has come meanwhile", async () => {
    const { engine, posted, worker } = started();
    await rest(posted, 0);
    const before = posted.length;
    engine.onFirstWork = () => {
      queueMicrotask(() => {
        worker.take({ kind: "events", events: [move, move], sequence: 3 });
      });
    };
    worker.take({ kind: "events", events: [move], sequence: 1 });
    await rest(posted, before);
    expect(engine.done.slice(0, 4)).toEqual(["event", "work", "event", "event"]);
    expect(engine.done.slice(4)).toEqual(["work", "work", "work", "work"]);
  });
});
