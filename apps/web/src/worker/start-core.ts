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
 * Brings back what the first of the journals gives that gives anything; they come in the order of what they know. Returns whether
 * something of it is gone.
 */
function recover(engine: CoreEngine, worker: CoreWorker, opened: OpenedSession): boolean {
  for (const generation of opened.generations) {
    engine.recover(generation.bytes, opened.name);
    const changes = engine.takeChanges();
    const isUsable = changes.isRecoveredWhole || !engine.state().isBlank;
    if (!isUsable && generation !== opened.generations.at(-1)) continue;
    // The journal on disk goes on as it is when every byte of it counted.
    const goesOn = changes.isRecoveredWhole && generation === opened.generations[0];
    const isNothingToTell = engine.state().isBlank || generation.isTorn;
    worker.collect({
      ...changes,
      messages: goesOn && isNothingToTell ? [] : changes.messages,
      journal: goesOn ? new Uint8Array() : changes.journal,
      isJournalNew: changes.isJournalNew && !goesOn,
    });
    return generation.isTorn || generation !== opened.generations[0];
  }
  return false;
}

/** A tab that has just died may hold its drawing for a moment. */
const dyingTabMs = 300;

async function freeSessions(store: JournalStore): Promise<SessionRow[]> {
  const sessions = await store.list();
  const locks = navigator.locks as LockManager | undefined;
  if (sessions.length > 0 || locks === undefined) return sessions;
  const { held } = await locks.query();
  if (held === undefined || held.length === 0) return sessions;
  await new Promise((resolve) => setTimeout(resolve, dyingTabMs));
  return store.list();
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
  const sessions = await freeSessions(store);
  const choice = sessionToOpen(start.startWith, sessions);
  const opened = await store.open(choice.session);
  const engine = await loading;
  engine.handle({ type: "action", name: "language", argument: start.language });
  engine.handle(start.view);
  const worker = new CoreWorker(engine, store, post);
  worker.collect(engine.takeChanges());
  const isSomethingGone = recover(engine, worker, opened);
  post({
    kind: "ready",
    session: opened.id,
    actions: engine.actions(),
    sessions: sessions.filter((session) => session.id !== opened.id),
    areOthersOffered: choice.isPanelOffered,
    isSomethingGone,
  });
  return worker;
}
