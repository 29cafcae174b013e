// SPDX-License-Identifier: Apache-2.0
import type { FromWorker, SessionRow, StartWith, ToWorker } from "../protocol/messages";
import { chooseSession, type SessionChoice } from "../storage/choose-session";
import type { JournalStore, OpenedSession } from "../storage/journal-store";
import { openJournalStore } from "../storage/open-journal-store";
import { CoreWorker } from "./core-worker";
import { CoreEngine } from "./engine";

type Start = Extract<ToWorker, { kind: "start" }>;
type Post = (message: FromWorker, transfer?: Transferable[]) => void;

function sessionToOpen(startWith: StartWith, sessions: readonly SessionRow[]): SessionChoice {
  switch (startWith.kind) {
    case "choose":
      return chooseSession(startWith.own, sessions, Date.now());
    case "session":
      return { session: startWith.session, isPanelOffered: false };
    case "new":
      return { session: null, isPanelOffered: false };
  }
}

/**
 * Brings back what the newest journal gives that gives anything. One that is torn is followed as far as it goes, since all that is
 * older knows less.
 */
function recover(engine: CoreEngine, worker: CoreWorker, opened: OpenedSession): void {
  const newest = opened.generations[0];
  for (const generation of opened.generations) {
    engine.recover(generation.bytes);
    const changes = engine.takeChanges();
    const isUsable = changes.isRecoveredWhole || !engine.state().isBlank;
    if (!isUsable && generation !== opened.generations.at(-1)) continue;
    // The journal on disk goes on as it is when every byte of it counted.
    const goesOn = changes.isRecoveredWhole && generation === newest;
    const messages = goesOn && engine.state().isBlank ? [] : changes.messages;
    worker.collect({
      ...changes,
      messages,
      journal: goesOn ? new Uint8Array() : changes.journal,
      isJournalNew: changes.isJournalNew && !goesOn,
    });
    return;
  }
}

/** Loads the core, takes a drawing up again, and is ready for events. */
export async function startCore(start: Start, post: Post): Promise<CoreWorker> {
  const loading = CoreEngine.load(start.wasm, (stage, share) => {
    post({ kind: "progress", stage, share });
  });
  const store: JournalStore = await openJournalStore();
  store.onState = (state) => {
    post({ kind: "save_state", state });
  };
  const sessions = await store.list();
  const choice = sessionToOpen(start.startWith, sessions);
  const opened = await store.open(choice.session);
  const engine = await loading;
  engine.handle({ type: "action", name: "language", argument: start.language });
  const worker = new CoreWorker(engine, store, post);
  worker.collect(engine.takeChanges());
  recover(engine, worker, opened);
  post({
    kind: "ready",
    session: opened.id,
    actions: engine.actions(),
    sessions: sessions.filter((session) => session.id !== opened.id),
    areOthersOffered: choice.isPanelOffered,
  });
  return worker;
}
