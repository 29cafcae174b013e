// SPDX-License-Identifier: Apache-2.0
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { WorkWatch } from "./long-work";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test("work that is over at once is never shown", () => {
  const watch = new WorkWatch();
  watch.progress("simplify", 0);
  watch.over();
  vi.advanceTimersByTime(1000);
  expect(watch.longWork.value).toBeNull();
});

test("long work is shown with the stage that it has reached", () => {
  const watch = new WorkWatch();
  watch.progress("simplify", 0);
  watch.progress("inflate", 0.5);
  vi.advanceTimersByTime(101);
  expect(watch.longWork.value).toEqual({ stage: "inflate", share: 0.5 });
  watch.progress("write", 0.9);
  expect(watch.longWork.value?.stage).toBe("write");
  watch.over();
  expect(watch.longWork.value).toBeNull();
});
