// SPDX-License-Identifier: Apache-2.0
import { batch, computed, signal, type ReadonlySignal } from "@preact/signals";
import type { ActionName } from "../protocol/actions.generated";
import type { CoreEvent, FileUse, ResizeInput } from "../protocol/events";
import type {
  CanvasRect,
  FileOut,
  Frame,
  FromWorker,
  SaveState,
  SessionRow,
} from "../protocol/messages";
import type { ActionRow, EngineState } from "../protocol/state";
import { chordText, isApple } from "./chords";
import { CoreClient, type CorePort } from "./core-client";
import { emptyState } from "./empty-state";
import { WorkWatch } from "./long-work";
import { NoticeBoard } from "./notices";
import type { MarkSide } from "./mark-side";
import type { Preferences } from "./preferences";
import { Replies } from "./replies";
import { takeRequest } from "./requests";
import { settled } from "./settled";
import type { Notice, Panel, Studio, Thumbnail } from "./studio";
import { tabSession } from "./tab-session";
import { Thumbnails } from "./thumbnails";
import { word, type Word } from "./words";

export interface StudioOptions {
  readonly preferences: Preferences;
  readonly startWorker: (listen: (message: FromWorker) => void) => CorePort;
  readonly loadCore: () => Promise<WebAssembly.Module>;
  /** What the core is told of the window. */
  readonly view: () => ResizeInput;
}

type Ready = Extract<FromWorker, { kind: "ready" }>;

/** The studio over a core in a worker. Begins with start(). */
export class LiveStudio implements Studio {
  readonly state = signal<EngineState>(emptyState("en"));
  readonly actions = signal<readonly ActionRow[]>([]);
  readonly saveState = signal<SaveState>({ kind: "saving" });
  readonly sessions = signal<readonly SessionRow[]>([]);
  readonly panel = signal<Panel | null>(null);
  readonly markSide = signal<MarkSide>("outside");
  readonly isStarting = signal(true);
  readonly preferences: Preferences;
  onFiles: (files: readonly FileOut[]) => void = () => undefined;
  onOpen: (use: FileUse) => void = () => undefined;

  private readonly board = new NoticeBoard();
  private readonly watch = new WorkWatch();
  private readonly listeners = new Set<(frame: Frame) => void>();
  /** Number of the last event that a frame has told of. */
  private readonly answered = signal(0);
  private hasCoreWork = true;
  private readonly exports = new Replies<number, readonly FileOut[]>();
  private readonly rawSessions = new Replies<string, Uint8Array>();
  private readonly byName = computed(
    () => new Map(this.actions.value.map((row) => [row.name, row])),
  );
  private readonly enabled = computed(() => new Set(this.state.value.enabled));
  private readonly isApple = isApple(navigator.platform);
  private readonly client: CoreClient;
  private readonly thumbnails = new Thumbnails((message) => {
    this.client.ask(message);
  });

  constructor(options: StudioOptions) {
    this.preferences = options.preferences;
    this.client = new CoreClient({
      startWorker: options.startWorker,
      loadCore: options.loadCore,
      language: () => this.preferences.language.value,
      view: options.view,
      onMessage: (message) => {
        this.take(message);
      },
      onStart: () => {
        this.tellCore();
      },
      onHopeless: (why) => {
        this.giveUp(why);
      },
      nowMs: () => performance.now(),
    });
  }

  /** Takes up the drawing that this tab was at, or what an earlier run has left. */
  start(): void {
    void this.client.start({ kind: "choose", own: tabSession.kept() });
  }

  get longWork() {
    return this.watch.longWork;
  }

  get notices() {
    return this.board.notices;
  }

  word(name: Word, ...values: (string | number)[]): string {
    return word(name, this.preferences.language.value, ...values);
  }

  label(name: ActionName): string {
    return this.byName.value.get(name)?.labels[this.preferences.language.value] ?? name;
  }

  chord(name: ActionName): string {
    return chordText(this.byName.value.get(name)?.chords[0] ?? "", this.isApple);
  }

  isEnabled(name: ActionName): boolean {
    return this.enabled.value.has(name);
  }

  act(name: ActionName, argument = ""): void {
    this.send({ type: "action", name, argument });
  }

  send(event: CoreEvent): number {
    return this.client.send(event);
  }

  open(file: File, use: FileUse): void {
    file.arrayBuffer().then(
      (bytes) => this.send({ type: "file", bytes: new Uint8Array(bytes), name: file.name, use }),
      () => {
        this.notify("problem", this.word("cannot_read_file", file.name));
      },
    );
  }

  exportAs(extension: string): Promise<readonly FileOut[]> {
    return this.exports.wait(this.send({ type: "action", name: "export_as", argument: extension }));
  }

  /** Whether all that was sent shows, and nothing goes on by itself. */
  isAtRest(): boolean {
    return !this.hasCoreWork && this.answered.peek() >= this.client.lastSequence;
  }

  notify(
    severity: Notice["severity"],
    text: string,
    remedy: Notice["remedy"] = null,
    place: CanvasRect | null = null,
  ): void {
    this.board.add({ severity, text, place, remedy });
  }

  dismiss(id: number): void {
    this.board.dismiss(id);
  }

  cancelLongWork(): void {
    this.watch.over();
    this.client.restart();
  }

  thumbnail(layer: number, look: number): ReadonlySignal<Thumbnail | null> {
    return this.thumbnails.of(layer, look);
  }

  openSession(session: string | null): void {
    this.panel.value = null;
    void settled(this.client.lastSequence, this.answered, this.saveState).then(() =>
      this.client.start(session === null ? { kind: "new" } : { kind: "session", session }),
    );
  }

  forgetSession(session: string): void {
    this.client.ask({ kind: "forget_session", session });
  }

  refreshSessions(): void {
    this.client.ask({ kind: "list_sessions" });
  }

  rawSession(session: string): Promise<Uint8Array> {
    this.client.ask({ kind: "raw_session", session });
    return this.rawSessions.wait(session);
  }

  showPlace({ x, y, width, height }: CanvasRect): void {
    this.act("show_place", `${x},${y},${width},${height}`);
  }

  onFrame(listener: (frame: Frame) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** A core that starts knows nothing of how the person works. */
  private tellCore(): void {
    const { mode, tool } = this.state.peek();
    this.isStarting.value = true;
    this.exports.failAll("restarted");
    this.rawSessions.failAll("restarted");
    this.thumbnails.askAgain();
    this.act("single_keys", this.preferences.singleKeys.peek());
    if (tool !== "brush") this.act(tool === "select" ? "select_tool" : tool);
    if (mode !== "draw") this.act("mode_inflate");
  }

  private giveUp(why: string): void {
    this.notify("problem", this.word("core_hopeless", why));
    this.panel.value = "sessions";
  }

  private take(message: FromWorker): void {
    switch (message.kind) {
      case "frame":
        batch(() => {
          this.takeFrame(message);
        });
        return;
      case "ready":
        this.takeReady(message);
        return;
      case "progress":
        if (message.share === null) this.watch.over();
        else this.watch.progress(message.stage, message.share);
        return;
      case "save_state":
        this.saveState.value = message.state;
        return;
      case "thumbnail":
        this.thumbnails.take(message);
        return;
      case "sessions":
        this.sessions.value = message.sessions;
        return;
      case "raw_session":
        this.rawSessions.resolve((session) => session === message.session, message.bytes);
        return;
      case "fault":
        this.watch.over();
        this.notify("warning", this.word("core_back"));
        return;
    }
  }

  private takeReady(ready: Ready): void {
    batch(() => {
      this.isStarting.value = false;
      // Moving the model comes with a later version; until then its key shows the model as that of Inflate does.
      this.actions.value = ready.actions.filter((row) => row.name !== "mode_animate");
      this.sessions.value = ready.sessions;
    });
    tabSession.keep(ready.session);
    if (ready.isSomethingGone) this.notify("warning", this.word("something_gone"));
    if (!ready.areOthersOffered) return;
    this.notify("status", this.word("other_drawings"), {
      label: this.word("show_them"),
      run: () => (this.panel.value = "sessions"),
    });
  }

  private takeFrame(frame: Frame): void {
    this.watch.over();
    this.answered.value = frame.sequence;
    this.hasCoreWork = !frame.isAtRest;
    for (const listener of this.listeners) listener(frame);
    if (frame.state !== null) this.takeState(frame.state);
    const isExport = this.exports.resolve((asked) => asked <= frame.sequence, frame.files);
    if (!isExport && frame.files.length > 0) this.onFiles(frame.files);
    for (const { severity, text, place } of frame.messages) {
      // The core has only made the files: files/ tells once they are where the person wants them.
      const isTold = frame.files.length === 0 || severity !== "status";
      if (isTold) this.notify(severity, text, null, place);
    }
    for (const request of frame.requests) takeRequest(this, request);
  }

  private takeState(state: EngineState): void {
    this.state.value = state.mode === "animate" ? { ...state, mode: "inflate" } : state;
  }
}
