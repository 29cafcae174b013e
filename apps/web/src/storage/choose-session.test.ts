// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import type { SessionRow } from "../protocol/messages";
import { chooseSession, type SessionChoice } from "./choose-session";

const dayMs = 24 * 60 * 60 * 1000;
const nowMs = 1000 * dayMs;

function row(id: string, daysAgo: number, picture: number | null = null): SessionRow {
  const bytes = picture === null ? null : Uint8Array.of(picture);
  return { id, name: "Cat", changedMs: nowMs - daysAgo * dayMs, picture: bytes };
}

const opened = (session: string | null): SessionChoice => ({ session, isPanelOffered: false });
const offered = (session: string): SessionChoice => ({ session, isPanelOffered: true });

describe("the drawing to go on with", () => {
  it("is the tab's own", () => {
    expect(chooseSession("mine", [row("a", 0), row("b", 1)], nowMs)).toEqual(opened("mine"));
  });

  it("is the only recent one, without a question", () => {
    expect(chooseSession(null, [row("a", 6.9), row("old", 7.1)], nowMs)).toEqual(opened("a"));
  });

  it("is a new one where all are old", () => {
    const old = [row("old", 8), row("older", 9)];
    expect(chooseSession(null, old, nowMs)).toEqual(opened(null));
    expect(chooseSession(null, [], nowMs)).toEqual(opened(null));
  });

  it("is the newest of several, and the others are offered", () => {
    expect(chooseSession(null, [row("a", 0, 1), row("b", 1, 2)], nowMs)).toEqual(offered("a"));
    expect(chooseSession(null, [row("a", 0), row("b", 1)], nowMs)).toEqual(offered("a"));
  });

  it("is the newest of several that look alike, without a question", () => {
    expect(chooseSession(null, [row("a", 0, 1), row("b", 1, 1)], nowMs)).toEqual(opened("a"));
  });
});
