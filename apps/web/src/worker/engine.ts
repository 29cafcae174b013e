// SPDX-License-Identifier: Apache-2.0
import createCore, { type Address, type CoreExports } from "#core";
import type { CoreEvent } from "../protocol/events";
import type { SceneUpdate } from "../protocol/scene";
import type { ActionRow, EngineState } from "../protocol/state";
import type { Answer, BlobPlace } from "./answer";
import { CoreFault } from "./core-fault";
import { CoreMemory } from "./core-memory";
import type { EngineChanges } from "./engine-changes";
import { readChanges, type ChangesHead } from "./read-changes";
import { readScene, type SceneHead } from "./read-scene";
import { sendEvent } from "./send-event";

/** Called in the midst of long work; share: 0 .. 1. */
export type OnProgress = (stage: string, share: number) => void;

export interface LayerPicture {
  readonly width: number;
  readonly height: number;
  /** RGBA */
  readonly pixels: Uint8ClampedArray;
}

interface LayerPictureHead {
  readonly width: number;
  readonly height: number;
  readonly pixels: BlobPlace;
}

/**
 * The whole program without a window: src/editor/engine.h, as WebAssembly. Every function may throw a CoreFault, after which all of
 * them do.
 */
export class CoreEngine {
  private readonly memory: CoreMemory;
  private readonly engine: Address;
  private fault: CoreFault | null = null;

  private constructor(
    private readonly core: CoreExports,
    /** What the core has said before it stopped. */
    private readonly lastWords: string[],
  ) {
    this.memory = new CoreMemory(core);
    this.engine = core._engine_new();
  }

  static load(wasm: WebAssembly.Module, onProgress: OnProgress): Promise<CoreEngine> {
    const lastWords: string[] = [];
    // What createCore makes of a failed start is a promise that is never settled.
    return new Promise((resolve, reject) => {
      const core = createCore({
        instantiateWasm: (imports, receive) => {
          WebAssembly.instantiate(wasm, imports).then(receive, reject);
          return {};
        },
        onProgress,
        printErr: (line) => lastWords.push(line),
      });
      core.then((started) => {
        resolve(new CoreEngine(started, lastWords));
      }, reject);
    });
  }

  handle(event: CoreEvent): void {
    this.guarded(() => {
      sendEvent(this.core, this.memory, this.engine, event);
    });
  }

  /** Work put off so that events are answered at once. */
  hasWork(): boolean {
    return this.guarded(() => this.core._engine_has_work(this.engine) !== 0);
  }

  work(): void {
    this.guarded(() => {
      this.core._engine_work(this.engine);
    });
  }

  /** Goes on from a journal that an earlier run has left; fileName: what the drawing was called, "": it had no name. */
  recover(journal: Uint8Array, fileName: string): void {
    this.guarded(() => {
      this.memory.with([journal, fileName], (placed, name) => {
        const { address, bytes } = placed;
        this.core._engine_recover(this.engine, address, bytes, name.address, name.bytes);
      });
    });
  }

  /** What has changed since this was last asked. */
  takeChanges(): EngineChanges {
    const take = () => this.core._engine_take_changes(this.engine);
    return readChanges(this.required<ChangesHead>(take));
  }

  /** Without what the scene before had; all of its arrays share one buffer. */
  scene(): SceneUpdate {
    return readScene(this.required<SceneHead>(() => this.core._engine_scene(this.engine)));
  }

  state(): EngineState {
    return this.required<EngineState>(() => this.core._engine_state(this.engine)).head;
  }

  actions(): ActionRow[] {
    return this.required<ActionRow[]>(() => this.core._engine_actions(this.engine)).head;
  }

  /** One layer on a clear ground; null: there is no such layer. */
  thumbnail(layer: number, sizePx: number): LayerPicture | null {
    const draw = () => this.core._engine_thumbnail(this.engine, layer, sizePx);
    const answer = this.answer<LayerPictureHead>(draw);
    if (answer === null) return null;
    const { width, height, pixels } = answer.head;
    return { width, height, pixels: new Uint8ClampedArray(answer.ownBytes(pixels).buffer) };
  }

  /** The whole drawing as PNG; null: nothing is drawn. */
  picture(sizePx: number): Uint8Array | null {
    const draw = () => this.core._engine_picture(this.engine, sizePx);
    const answer = this.answer<{ readonly png: BlobPlace }>(draw);
    return answer && answer.ownBytes(answer.head.png);
  }

  delete(): void {
    this.guarded(() => {
      this.core._engine_delete(this.engine);
    });
  }

  private answer<Head>(ask: () => Address): Answer<Head> | null {
    return this.memory.answer<Head>(this.guarded(ask));
  }

  private required<Head>(ask: () => Address): Answer<Head> {
    const answer = this.answer<Head>(ask);
    if (answer === null) throw new CoreFault("the core gave no answer");
    return answer;
  }

  /** A trap leaves the core's memory in the midst of a change: nothing may be asked of it again. */
  private guarded<T>(call: () => T): T {
    if (this.fault !== null) throw this.fault;
    try {
      return call();
    } catch (error) {
      const why = [...this.lastWords, String(error)].join("\n");
      this.fault = new CoreFault(why, { cause: error });
      throw this.fault;
    }
  }
}
