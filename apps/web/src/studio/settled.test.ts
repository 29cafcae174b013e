// SPDX-License-Identifier: Apache-2.0
import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { SaveState } from "../protocol/messages";
import { settled } from "./settled";

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

/** Whether it has settled so far. */
async function isOver(waiting: Promise<void>): Promise<boolean> {
  let isResolved = false;
  void waiting.then(() => (isResolved = true));
  await vi.advanceTimersByTimeAsync(0);
  return isResolved;
}

test("what the core has not taken in yet is waited for, then the disk", async () => {
  const answered = signal(4);
  const saveState = signal<SaveState>({ kind: "saved", timeMs: 0 });
  const waiting = settled(5, answered, saveState);
  expect(await isOver(waiting)).toBe(false);
  saveState.value = { kind: "saving" };
  answered.value = 5;
  expect(await isOver(waiting)).toBe(false);
  saveState.value = { kind: "saved", timeMs: 1 };
  expect(await isOver(waiting)).toBe(true);
});

test("a disk that refuses is not waited for", async () => {
  const refused = signal<SaveState>({ kind: "refused", why: "full" });
  expect(await isOver(settled(5, signal(5), refused))).toBe(true);
});

test("a core that never answers is not waited for for ever", async () => {
  const waiting = settled(5, signal(4), signal<SaveState>({ kind: "saving" }));
  expect(await isOver(waiting)).toBe(false);
  await vi.runAllTimersAsync();
  expect(await isOver(waiting)).toBe(true);
});
