// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from "vitest";
import type { CoreEvent } from "../protocol/events";
import type { FromWorker } from "../protocol/messages";
import { Unanswered } from "./unanswered";

const act = (name: "undo" | "redo" | "simplify"): CoreEvent => ({
  type: "action",
  name,
  argument: "",
});
const file: CoreEvent = { type: "file", bytes: new Uint8Array(1), name: "a.svg", use: "open" };

function frame(sequence: number, isAtRest: boolean): FromWorker {
  const nothing = { scene: null, state: null, messages: [], files: [], requests: [] };
  return { kind: "frame", sequence, isAtRest, ...nothing };
}

const workIsOver: FromWorker = { kind: "progress", stage: "", share: null };

describe("Unanswered", () => {
  test("leaves out what the core was at: it would be at it again", () => {
    const unanswered = new Unanswered();
    unanswered.sent([act("simplify")], 1);
    unanswered.sent([act("undo"), act("redo")], 3);
    unanswered.heard({ kind: "progress", stage: "close", share: 0.2 });
    expect(unanswered.take()).toEqual([act("undo"), act("redo")]);
    expect(unanswered.take()).toEqual([]);
  });

  test("keeps all that came while the core did what it had put off", () => {
    const unanswered = new Unanswered();
    unanswered.sent([act("simplify")], 1);
    unanswered.heard(frame(1, false));
    unanswered.sent([act("undo")], 2);
    expect(unanswered.take()).toEqual([act("undo")]);
  });

  test("knows that events come first once that work is over", () => {
    const unanswered = new Unanswered();
    unanswered.heard(frame(0, false));
    unanswered.sent([act("undo")], 1);
    unanswered.sent([act("redo")], 2);
    unanswered.heard(workIsOver);
    expect(unanswered.take()).toEqual([act("redo")]);
  });

  test("forgets what was answered, and files, which are gone", () => {
    const unanswered = new Unanswered();
    unanswered.sent([act("simplify")], 1);
    unanswered.sent([act("simplify")], 2);
    unanswered.heard(frame(1, true));
    unanswered.sent([act("undo"), file, act("redo")], 5);
    expect(unanswered.take()).toEqual([act("undo"), act("redo")]);
  });
});
