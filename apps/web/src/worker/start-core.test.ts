// SPDX-License-Identifier: Apache-2.0
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { describe, expect, test, vi } from "vitest";
import { noEdges } from "../protocol/events";
import type { Frame, FromWorker } from "../protocol/messages";
import type { OpenedSession } from "../storage/journal-store";
import { MemoryJournalStore } from "../storage/memory-journal-store";
import { Artist, coreFolder } from "./artist";
import { startCore } from "./start-core";

const isBuilt = existsSync(new URL("core.wasm", coreFolder));
const kept = vi.hoisted(() => ({ journal: new Uint8Array() }));

/** What an earlier run has left. */
class KeptJournalStore extends MemoryJournalStore {
  override open(): Promise<OpenedSession> {
    const generation = { number: 1, bytes: kept.journal, isTorn: false };
    return Promise.resolve({ id: "kept", name: "cat", generations: [generation] });
  }
}

vi.mock("../storage/open-journal-store", () => ({
  openJournalStore: () => Promise.resolve(new KeptJournalStore(() => "new")),
}));
vi.stubGlobal("navigator", {});

/** The first frame of a core that takes up what was kept. */
async function firstFrame(width: number, height: number) {
  const wasm = await readFile(new URL("core.wasm", coreFolder));
  return new Promise<Frame>((resolve, reject) => {
    const take = (message: FromWorker) => {
      if (message.kind === "frame") resolve(message);
    };
    WebAssembly.compile(new Uint8Array(wasm))
      .then((module) =>
        startCore(
          {
            kind: "start",
            wasm: module,
            startWith: { kind: "new" },
            language: "en",
            view: { type: "resize", width, height, edges: { ...noEdges, top: 50, bottom: 50 } },
          },
          take,
        ),
      )
      .catch(reject);
  });
}

describe.skipIf(!isBuilt)("a core that starts", () => {
  test("knows what the drawing that comes back is called", async () => {
    const artist = await Artist.start();
    artist.circle(500, 500, 300);
    kept.journal = new Uint8Array(artist.changes().journal);
    expect((await firstFrame(390, 844)).state).toMatchObject({ fileName: "cat", isBlank: false });
  });

  test("fits the drawing that comes back into the window, however large that is", async () => {
    const artist = await Artist.start();
    artist.circle(500, 500, 300);
    kept.journal = new Uint8Array(artist.changes().journal);
    for (const [width, height] of [
      [390, 844],
      [1440, 900],
    ] as const) {
      const scene = (await firstFrame(width, height)).scene!;
      expect([scene.width, scene.height]).toEqual([width, height]);
      const [scale, , , , x, y] = scene.canvasToScreen;
      expect(x + scale * 500).toBeCloseTo(width / 2, 0);
      expect(y + scale * 500).toBeCloseTo(height / 2, 0);
      const share = (600 * scale) / Math.min(width, height - 100);
      expect(share).toBeGreaterThan(0.8);
      expect(share).toBeLessThan(1);
    }
  });
});
