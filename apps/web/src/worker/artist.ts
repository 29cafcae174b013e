// SPDX-License-Identifier: Apache-2.0
import { readFile } from "node:fs/promises";
import type { ActionName } from "../protocol/actions.generated";
import { noEdges, type PointerAction } from "../protocol/events";
import { CoreEngine } from "./engine";
import type { EngineChanges } from "./engine-changes";

const noModifiers = { isShift: false, isCtrl: false, isAlt: false };
const viewSidePx = 1000;

/** Where the build of the core puts it. */
export const coreFolder = new URL("../../../../build/wasm/apps/web/", import.meta.url);

/** Someone who works with the real core, for tests. */
export class Artist {
  readonly stages: string[] = [];
  readonly shares: number[] = [];
  private timeS = 0;

  private constructor(readonly engine: CoreEngine) {}

  static async start(): Promise<Artist> {
    const wasm = await readFile(new URL("core.wasm", coreFolder));
    const told: { to?: Artist } = {};
    const engine = await CoreEngine.load(
      await WebAssembly.compile(new Uint8Array(wasm)),
      (stage, share) => {
        told.to?.stages.push(stage);
        told.to?.shares.push(share);
      },
    );
    const artist = new Artist(engine);
    told.to = artist;
    engine.handle({ type: "resize", width: viewSidePx, height: viewSidePx, edges: noEdges });
    return artist;
  }

  /** A circle in two halves with small gaps between them. */
  circle(x: number, y: number, radius: number): void {
    for (const from of [0.04, Math.PI + 0.04]) {
      const steps = 24;
      for (let i = 0; i <= steps; ++i) {
        const angle = from + ((Math.PI - 0.08) * i) / steps;
        const action = i === 0 ? "press" : i === steps ? "release" : "move";
        this.pointer(action, x + radius * Math.cos(angle), y + radius * Math.sin(angle));
      }
    }
  }

  act(name: ActionName, argument = ""): void {
    this.engine.handle({ type: "action", name, argument });
  }

  /** Does all that has been put off. */
  work(): void {
    while (this.engine.hasWork()) this.engine.work();
  }

  changes(): EngineChanges {
    return this.engine.takeChanges();
  }

  private pointer(action: PointerAction, x: number, y: number): void {
    this.timeS += 0.01;
    this.engine.handle({
      type: "pointer",
      action,
      kind: "mouse",
      id: 1,
      button: action === "move" ? "none" : "primary",
      x,
      y,
      pressure: 0.5,
      timeS: this.timeS,
      modifiers: noModifiers,
    });
  }
}
