// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import {
  holdCountdown,
  resumeCountdown,
  shownForMs,
  startCountdown,
  timeLeft,
} from "./notice-timing";

const remedy = { label: "Try again", run: () => undefined };
const place = { x: 0, y: 0, width: 1, height: 1 };

describe("how long a notice is shown", () => {
  it("a problem stays until it is put away", () => {
    expect(shownForMs({ severity: "problem", place: null, remedy: null })).toBeNull();
  });

  it("a status goes by itself after four seconds", () => {
    expect(shownForMs({ severity: "status", place: null, remedy: null })).toBe(4000);
  });

  it("what can be acted on stays longer than what cannot", () => {
    expect(shownForMs({ severity: "status", place, remedy: null })).toBeGreaterThan(4000);
    expect(shownForMs({ severity: "warning", place: null, remedy })).toBeNull();
    expect(shownForMs({ severity: "warning", place: null, remedy: null })).not.toBeNull();
  });
});

describe("a countdown", () => {
  it("runs down to nothing and no farther", () => {
    const countdown = startCountdown(4000, 1000);
    expect(timeLeft(countdown, 3000)).toBe(2000);
    expect(timeLeft(countdown, 99_000)).toBe(0);
  });

  it("stands still while it is held", () => {
    const held = holdCountdown(startCountdown(4000, 1000), 2000);
    expect(timeLeft(held, 50_000)).toBe(3000);
    expect(timeLeft(holdCountdown(held, 60_000), 70_000)).toBe(3000);
  });

  it("goes on with what was left", () => {
    const held = holdCountdown(startCountdown(4000, 0), 1000);
    const resumed = resumeCountdown(held, 10_000);
    expect(timeLeft(resumed, 11_000)).toBe(2000);
    expect(resumeCountdown(resumed, 12_000)).toBe(resumed);
  });
});
