// SPDX-License-Identifier: Apache-2.0
import { batch, computed, effect, signal } from "@preact/signals";
import type { ActionName } from "../protocol/actions.generated";
import type { FileUse } from "../protocol/events";
import type { FileOut, Frame, FromWorker, SaveState, SessionRow } from "../protocol/messages";
import type { ActionRow, EngineState } from "../protocol/state";
import { chordText, isApple } from "./chords";
import { CoreClient, type CorePort } from "./core-client";
import { emptyState } from "./empty-state";
import { WorkWatch } from "./long-work";
import { NoticeBoard } from "./notices";
import type { Preferences } from "./preferences";
import { Replies } from "./replies";
import { takeRequest } from "./requests";
import type { Panel, Studio } from "./studio";
import { tabSession } from "./tab-session";
import { Thumbnails } from "./thumbnails";
import { word, type Word } from "./words";

export interface StudioOptions {
  readonly preferences: Preferences;
  readonly startWorker: (listen: (message: FromWorker) => void) => CorePort;
  readonly loadCore: () => Promise<ArrayBuffer>;
}

/** Puts the studio together and starts its core. */
export function createStudio(options: StudioOptions): Studio {
  const { preferences } = options;
  const state = signal<EngineState>(emptyState(preferences.language.value));
  const actions = signal<readonly ActionRow[]>([]);
  const saveState = signal<SaveState>({ kind: "saving" });
  const sessions = signal<readonly SessionRow[]>([]);
  const panel = signal<Panel | null>(null);
  const isStarting = signal(true);
  const byName = computed(() => new Map(actions.value.map((row) => [row.name, row])));
  const enabled = computed(() => new Set(state.value.enabled));
  const board = new NoticeBoard();
  const watch = new WorkWatch();
  const listeners = new Set<(frame: Frame) => void>();
  const exports = new Replies<readonly FileOut[]>();
  const rawSessions = new Replies<Uint8Array>();
  const apple = isApple(navigator.platform);

  const client = new CoreClient({
    startWorker: options.startWorker,
    loadCore: options.loadCore,
    language: () => preferences.language.value,
    onMessage: take,
    onStart,
    onHopeless(why) {
      studio.notify("problem", studio.word("core_hopeless", why));
      studio.panel.value = "sessions";
    },
    nowMs: () => performance.now(),
  });
  const thumbnails = new Thumbnails((message) => {
    client.ask(message);
  });

  function onStart(): void {
    const { mode, tool } = state.peek();
    isStarting.value = true;
    exports.failAll("restarted");
    thumbnails.askAgain();
    studio.act("single_keys", preferences.singleKeys.peek());
    if (tool !== "brush") studio.act(tool === "select" ? "select_tool" : tool);
    if (mode === "inflate") studio.act("mode_inflate");
  }

  function takeFrame(frame: Frame): void {
    watch.over();
    for (const listener of listeners) listener(frame);
    if (frame.state !== null) state.value = frame.state;
    const isExport = exports.resolve(frame.sequence, frame.files);
    if (!isExport && frame.files.length > 0) studio.onFiles(frame.files);
    for (const message of frame.messages) {
      // The core has only made the files: files/ tells once they are where the person wants them.
      const isTold = frame.files.length === 0 || message.severity !== "status";
      if (isTold) board.add({ ...message, remedy: null });
    }
    for (const request of frame.requests) takeRequest(studio, request);
  }

  function take(message: FromWorker): void {
    switch (message.kind) {
      case "frame":
        batch(() => {
          takeFrame(message);
        });
        return;
      case "ready":
        batch(() => {
          isStarting.value = false;
          actions.value = message.actions;
          sessions.value = message.sessions;
        });
        tabSession.keep(message.session);
        if (message.areOthersOffered) offerSessions(studio);
        return;
      case "progress":
        if (message.share === null) watch.over();
        else watch.progress(message.stage, message.share);
        return;
      case "save_state":
        saveState.value = message.state;
        return;
      case "thumbnail":
        thumbnails.take(message);
        return;
      case "sessions":
        sessions.value = message.sessions;
        return;
      case "raw_session":
        rawSessions.resolveAll(message.bytes);
        return;
      case "fault":
        watch.over();
        board.add({
          severity: "warning",
          text: studio.word("core_back"),
          place: null,
          remedy: null,
        });
        return;
    }
  }

  const studio: Studio = {
    state,
    actions,
    saveState,
    longWork: watch.longWork,
    notices: board.notices,
    sessions,
    panel,
    preferences,
    isStarting,
    word: (name: Word, ...values: (string | number)[]) =>
      word(name, preferences.language.value, ...values),
    label: (name: ActionName) => byName.value.get(name)?.labels[preferences.language.value] ?? name,
    chord: (name: ActionName) => chordText(byName.value.get(name)?.chords[0] ?? "", apple),
    isEnabled: (name: ActionName) => enabled.value.has(name),
    act: (name, argument = "") => {
      client.send({ type: "action", name, argument });
    },
    send: (event) => client.send(event),
    open: (file, use) => void openFile(client, file, use, studio),
    exportAs: (extension) =>
      exports.wait(client.send({ type: "action", name: "export_as", argument: extension })),
    notify: (severity, text, remedy = null) => {
      board.add({ severity, text, place: null, remedy });
    },
    dismiss: (id) => {
      board.dismiss(id);
    },
    cancelLongWork: () => {
      watch.over();
      client.restart();
    },
    thumbnail: (layer, look) => thumbnails.of(layer, look),
    openSession: (session) => {
      panel.value = null;
      void client.start(session === null ? { kind: "new" } : { kind: "session", session });
    },
    forgetSession: (session) => {
      client.ask({ kind: "forget_session", session });
    },
    refreshSessions: () => {
      client.ask({ kind: "list_sessions" });
    },
    rawSession: (session) => {
      client.ask({ kind: "raw_session", session });
      return rawSessions.wait(0);
    },
    showPlace: (place) => {
      studio.act("show_place", `${place.x},${place.y},${place.width},${place.height}`);
    },
    onFrame: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    onFiles: () => undefined,
    onOpen: () => undefined,
  };

  tellPreferences(studio);
  void client.start({ kind: "choose", own: tabSession.kept() });
  return studio;
}

async function openFile(
  client: CoreClient,
  file: File,
  use: FileUse,
  studio: Studio,
): Promise<void> {
  try {
    const bytes = new Uint8Array(await file.arrayBuffer());
    client.send({ type: "file", bytes, name: file.name, use });
  } catch {
    studio.notify("problem", studio.word("cannot_read_file", file.name));
  }
}

/** The core speaks the language and knows the keys that the person has chosen. */
function tellPreferences(studio: Studio): void {
  const { language, singleKeys } = studio.preferences;
  let isFirst = true;
  effect(() => {
    const wanted = language.value;
    const keys = singleKeys.value;
    if (!isFirst) {
      studio.act("language", wanted);
      studio.act("single_keys", keys);
    }
    isFirst = false;
  });
}

/** More than one drawing was left: the newest is open, and the others are told of. */
function offerSessions(studio: Studio): void {
  studio.notify("status", studio.word("other_drawings"), {
    label: studio.word("show_them"),
    run: () => (studio.panel.value = "sessions"),
  });
}
