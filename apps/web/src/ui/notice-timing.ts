// SPDX-License-Identifier: Apache-2.0
import type { Notice } from "../studio/studio";

/** Time that runs down, and stands still while somebody reads. */
export interface Countdown {
  readonly leftMs: number;
  /** Runs since then; null: stands still. */
  readonly sinceMs: number | null;
}

/** How long a notice is shown; null: until it is put away. */
export function shownForMs(notice: Pick<Notice, "severity" | "place" | "remedy">): number | null {
  const asksForSomething = notice.place !== null || notice.remedy !== null;
  switch (notice.severity) {
    case "status":
      return asksForSomething ? 10_000 : 4_000;
    case "warning":
      return asksForSomething ? null : 8_000;
    case "problem":
      return null;
  }
}

export function startCountdown(totalMs: number, nowMs: number): Countdown {
  return { leftMs: totalMs, sinceMs: nowMs };
}

export function timeLeft(countdown: Countdown, nowMs: number): number {
  const passed = countdown.sinceMs === null ? 0 : nowMs - countdown.sinceMs;
  return Math.max(0, countdown.leftMs - passed);
}

export function holdCountdown(countdown: Countdown, nowMs: number): Countdown {
  return { leftMs: timeLeft(countdown, nowMs), sinceMs: null };
}

export function resumeCountdown(countdown: Countdown, nowMs: number): Countdown {
  return countdown.sinceMs === null ? { ...countdown, sinceMs: nowMs } : countdown;
}
