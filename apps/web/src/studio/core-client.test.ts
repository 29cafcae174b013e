// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from "vitest";
import type { CoreEvent } from "../protocol/events";
import { noEdges } from "../protocol/events";
import type { FromWorker, ToWorker } from "../protocol/messages";
import { CoreClient } from "./core-client";

const undo: CoreEvent = { type: "action", name: "undo", argument: "" };

/** The shortest that is valid. */
const emptyModule = new WebAssembly.Module(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]));

/** A client whose workers do nothing but write down what they are sent. */
function clientWithWorkers() {
  const workers: {
    sent: ToWorker[];
    isEnded: boolean;
    say: (message: FromWorker) => void;
  }[] = [];
  const heard: FromWorker[] = [];
  const hopeless: string[] = [];
  let now = 0;
  const client: CoreClient = new CoreClient({
    startWorker(listen) {
      const worker = { sent: [] as ToWorker[], isEnded: false, say: listen };
      workers.push(worker);
      return {
        post: (message) => worker.sent.push(message),
        end: () => (worker.isEnded = true),
      };
    },
    loadCore: () => Promise.resolve(emptyModule),
    language: () => "en",
    view: () => ({ type: "resize", width: 390, height: now + 1, edges: noEdges }),
    onMessage: (message) => heard.push(message),
    onStart: () => {
      client.send({ type: "resize", width: 10, height: 20, edges: noEdges });
    },
    onHopeless: (why) => hopeless.push(why),
    nowMs: () => now,
  });
  const settled = () => new Promise((resolve) => setTimeout(resolve));
  const ready = (session: string): FromWorker => ({
    kind: "ready",
    session,
    actions: [],
    sessions: [],
    areOthersOffered: false,
    isSomethingGone: false,
  });
  return { client, workers, heard, hopeless, settled, ready, later: (ms: number) => (now += ms) };
}

describe("CoreClient", () => {
  test("sends what came before the core was there after what tells it of the window", async () => {
    const { client, workers, settled } = clientWithWorkers();
    client.send(undo);
    await client.start({ kind: "new" });
    await settled();
    const [start, events] = workers[0]!.sent;
    expect(start?.kind).toBe("start");
    expect(events).toMatchObject({
      kind: "events",
      sequence: 2,
      events: [{ type: "resize" }, { type: "action" }],
    });
  });

  test("tells each worker with its first message how large the window is now", async () => {
    const { client, workers, settled, later } = clientWithWorkers();
    await client.start({ kind: "new" });
    later(843);
    client.restart();
    await settled();
    const views = workers.map(({ sent }) => sent[0]);
    expect(views).toMatchObject([
      { kind: "start", view: { width: 390, height: 1 } },
      { kind: "start", view: { width: 390, height: 844 } },
    ]);
  });

  test("sends the events of one turn together, with the number of the last", async () => {
    const { client, workers, settled } = clientWithWorkers();
    await client.start({ kind: "new" });
    await settled();
    client.send(undo);
    const last = client.send(undo);
    await settled();
    expect(workers[0]!.sent.at(-1)).toMatchObject({ sequence: last, events: [undo, undo] });
  });

  test("goes on with the same drawing after a fault", async () => {
    const { client, workers, settled, ready } = clientWithWorkers();
    await client.start({ kind: "choose", own: null });
    workers[0]!.say(ready("a"));
    workers[0]!.say({ kind: "fault", why: "trap" });
    await settled();
    expect(workers).toHaveLength(2);
    expect(workers[0]!.isEnded).toBe(true);
    expect(workers[1]!.sent[0]).toMatchObject({ startWith: { kind: "session", session: "a" } });
  });

  test("sends what a worker has not begun to the one that takes its place", async () => {
    const { client, workers, settled, ready } = clientWithWorkers();
    await client.start({ kind: "new" });
    workers[0]!.say(ready("a"));
    await settled();
    for (const name of ["simplify", "undo", "redo"] as const) {
      client.send({ type: "action", name, argument: "" });
      await settled();
    }
    const { isAtRest, sequence } = { isAtRest: true, sequence: 1 };
    const nothing = { scene: null, state: null, messages: [], files: [], requests: [] };
    workers[0]!.say({ kind: "frame", sequence, isAtRest, ...nothing });
    client.restart();
    client.send(undo);
    await settled();
    const [, events] = workers[1]!.sent;
    const names = events?.kind === "events" ? events.events.map((each) => each.type) : [];
    expect(names).toEqual(["resize", "action", "action", "action"]);
    expect(events).toMatchObject({
      events: [{}, { name: "undo" }, { name: "redo" }, { name: "undo" }],
      sequence: client.lastSequence,
    });
  });

  test("begins a new drawing when one stops the core again and again", async () => {
    const { client, workers, hopeless, settled, ready } = clientWithWorkers();
    await client.start({ kind: "choose", own: null });
    for (let fault = 0; fault < 3; ++fault) {
      workers.at(-1)!.say(ready("a"));
      workers.at(-1)!.say({ kind: "fault", why: "trap" });
      await settled();
    }
    expect(hopeless).toEqual(["trap"]);
    expect(workers.at(-1)!.sent[0]).toMatchObject({ startWith: { kind: "new" } });
  });

  test("does not count faults that lie far apart", async () => {
    const { client, workers, hopeless, settled, ready, later } = clientWithWorkers();
    await client.start({ kind: "choose", own: null });
    for (let fault = 0; fault < 5; ++fault) {
      workers.at(-1)!.say(ready("a"));
      workers.at(-1)!.say({ kind: "fault", why: "trap" });
      await settled();
      later(60_000);
    }
    expect(hopeless).toEqual([]);
    expect(workers).toHaveLength(6);
  });

  test("stops starting workers when not even an empty drawing holds", async () => {
    const { client, workers, hopeless, settled } = clientWithWorkers();
    await client.start({ kind: "new" });
    for (let fault = 0; fault < 6; ++fault) {
      workers.at(-1)!.say({ kind: "fault", why: "no WebAssembly" });
      await settled();
    }
    expect(hopeless).toEqual(["no WebAssembly"]);
    expect(workers).toHaveLength(3);
  });

  test("runs one worker when it is asked to start twice at once: the last", async () => {
    const { client, workers, settled } = clientWithWorkers();
    void client.start({ kind: "session", session: "a" });
    void client.start({ kind: "session", session: "b" });
    await settled();
    const [first, last] = workers;
    expect(first).toMatchObject({ isEnded: true, sent: [] });
    expect(last?.isEnded).toBe(false);
    expect(last?.sent[0]).toMatchObject({ startWith: { kind: "session", session: "b" } });
  });

  test("does not listen to a worker that it has given up", async () => {
    const { client, workers, heard, settled, ready } = clientWithWorkers();
    await client.start({ kind: "new" });
    client.restart();
    await settled();
    workers[0]!.say(ready("old"));
    expect(heard).toEqual([]);
  });
});
