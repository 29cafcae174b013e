// SPDX-License-Identifier: Apache-2.0
import type {
  CoreMessage,
  FileOut,
  FromWorker,
  StudioRequest,
  ToWorker,
} from "../protocol/messages";
import type { SceneUpdate } from "../protocol/scene";
import type { JournalStore } from "../storage/journal-store";
import type { CoreEngine } from "./engine";
import type { EngineChanges } from "./engine-changes";
import { describeWhenIdle, type IdleDescriber } from "./idle-describer";

/** Of a scene's arrays, which share one buffer: it is handed over, not copied. */
function buffersOf(scene: SceneUpdate | null): Transferable[] {
  const lists = scene?.chunks.map(({ list }) => list) ?? [];
  const any = [scene?.model?.mesh?.positions, ...lists].find((array) => array?.buffer);
  return any ? [any.buffer] : [];
}

type Post = (message: FromWorker, transfer?: Transferable[]) => void;

/**
 * Between the page's messages and the engine. Events are answered by one frame for all that have come; work that can wait is done
 * when no event does.
 */
export class CoreWorker {
  private sequence = 0;
  private isSceneStale = true;
  private isStateStale = true;
  private messages: CoreMessage[] = [];
  private files: FileOut[] = [];
  private requests: StudioRequest[] = [];
  private isTurnAsked = false;
  private readonly turn = new MessageChannel();
  private readonly describer: IdleDescriber;

  constructor(
    private readonly engine: CoreEngine,
    private readonly store: JournalStore,
    private readonly post: Post,
  ) {
    this.describer = describeWhenIdle(engine, store);
    // A message to ourselves waits behind those of the page that are here already.
    this.turn.port1.onmessage = () => {
      this.guard(() => {
        this.takeTurn();
      });
    };
    this.askTurn();
  }

  take(message: ToWorker): void {
    this.guard(() => {
      this.answer(message);
    });
  }

  /** Takes over what the engine has to tell. */
  collect(changes: EngineChanges): void {
    if (changes.isJournalNew) this.store.startNew(changes.journal);
    else if (changes.journal.length > 0) this.store.append(changes.journal);
    if (changes.isDocumentChanged) this.describer.changed();
    this.isSceneStale ||= changes.isSceneChanged;
    this.isStateStale ||= changes.isStateChanged || changes.isDocumentChanged;
    this.messages.push(...changes.messages);
    this.files.push(...changes.files);
    this.requests.push(...changes.requests);
  }

  private answer(message: ToWorker): void {
    switch (message.kind) {
      case "start":
        return;
      case "events":
        for (const event of message.events) this.engine.handle(event);
        this.collect(this.engine.takeChanges());
        this.sequence = message.sequence;
        this.askTurn();
        return;
      case "thumbnail":
        this.sendThumbnail(message.layer, message.look, message.sizePx);
        return;
      case "list_sessions":
        void this.sendSessions();
        return;
      case "forget_session":
        void this.store.forget(message.session).then(() => this.sendSessions());
        return;
      case "raw_session":
        void this.store.raw(message.session).then((bytes) => {
          this.post({ kind: "raw_session", session: message.session, bytes });
        });
        return;
    }
  }

  private askTurn(): void {
    if (this.isTurnAsked) return;
    this.isTurnAsked = true;
    this.turn.port2.postMessage(null);
  }

  private takeTurn(): void {
    this.isTurnAsked = false;
    const hasWork = this.engine.hasWork();
    this.sendFrame(!hasWork);
    if (!hasWork) return;
    this.engine.work();
    this.post({ kind: "progress", stage: "", share: null });
    this.collect(this.engine.takeChanges());
    this.askTurn();
  }

  private sendFrame(isAtRest: boolean): void {
    const scene = this.isSceneStale ? this.engine.scene() : null;
    const state = this.isStateStale ? this.engine.state() : null;
    if (state !== null) this.store.rename(state.fileName);
    const transfer = [...this.files.map((file) => file.bytes.buffer), ...buffersOf(scene)];
    this.post(
      {
        kind: "frame",
        sequence: this.sequence,
        isAtRest,
        scene,
        state,
        messages: this.messages,
        files: this.files,
        requests: this.requests,
      },
      transfer,
    );
    this.isSceneStale = this.isStateStale = false;
    this.messages = [];
    this.files = [];
    this.requests = [];
  }

  private sendThumbnail(layer: number, look: number, sizePx: number): void {
    const picture = this.engine.thumbnail(layer, sizePx);
    if (picture === null) return;
    this.post({ kind: "thumbnail", layer, look, ...picture }, [picture.pixels.buffer]);
  }

  private async sendSessions(): Promise<void> {
    this.post({ kind: "sessions", sessions: await this.store.list() });
  }

  /** An engine that has stopped cannot go on: the page starts another worker. */
  private guard(run: () => void): void {
    try {
      run();
    } catch (fault) {
      this.post({ kind: "fault", why: fault instanceof Error ? fault.message : String(fault) });
    }
  }
}
