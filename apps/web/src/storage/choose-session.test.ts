// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import type { SessionRow } from "../protocol/messages";
import { chooseSession, hasRivals } from "./choose-session";

const dayMs = 24 * 60 * 60 * 1000;
const nowMs = 1000 * dayMs;

function row(id: string, daysAgo: number, picture: number | null = null): SessionRow {
  const bytes = picture === null ? null : Uint8Array.of(picture);
  return { id, name: "Cat", changedMs: nowMs - daysAgo * dayMs, picture: bytes };
}

describe("the drawing to go on with", () => {
  it("is the tab's own", () => {
    const free = [row("a", 0), row("b", 1)];
    expect(chooseSession("mine", free, nowMs)).toBe("mine");
    expect(hasRivals("mine", free, nowMs)).toBe(false);
  });

  it("is the only recent one, without a question", () => {
    const free = [row("a", 6.9), row("old", 7.1)];
    expect(chooseSession(null, free, nowMs)).toBe("a");
    expect(hasRivals(null, free, nowMs)).toBe(false);
  });

  it("is a new one where all are old", () => {
    expect(chooseSession(null, [row("old", 8)], nowMs)).toBeNull();
    expect(hasRivals(null, [row("old", 8), row("older", 9)], nowMs)).toBe(false);
    expect(chooseSession(null, [], nowMs)).toBeNull();
  });

  it("is the newest of several, and the others are offered", () => {
    const free = [row("a", 0, 1), row("b", 1, 2)];
    expect(chooseSession(null, free, nowMs)).toBe("a");
    expect(hasRivals(null, free, nowMs)).toBe(true);
  });

  it("is the newest of several that look alike, without a question", () => {
    expect(hasRivals(null, [row("a", 0, 1), row("b", 1, 1)], nowMs)).toBe(false);
    expect(hasRivals(null, [row("a", 0), row("b", 1)], nowMs)).toBe(true);
  });
});
