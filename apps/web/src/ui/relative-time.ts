// SPDX-License-Identifier: Apache-2.0
import type { Language } from "../protocol/state";

const minuteS = 60;
const hourS = 60 * minuteS;
const dayS = 24 * hourS;

/** Up to how many seconds ago a unit is told, and how long it is. */
const units = [
  ["minute", hourS, minuteS],
  ["hour", dayS, hourS],
  ["day", 7 * dayS, dayS],
  ["week", 30 * dayS, 7 * dayS],
  ["month", 365 * dayS, 30 * dayS],
  ["year", Infinity, 365 * dayS],
] as const;

/** "5 minutes ago", "yesterday". Less than a minute, and what a clock that was set back makes of it, is now. */
export function relativeTime(thenMs: number, nowMs: number, language: Language): string {
  const words = new Intl.RelativeTimeFormat(language, { numeric: "auto" });
  const seconds = (nowMs - thenMs) / 1000;
  const unit = units.find(([, below]) => seconds < below);
  if (unit === undefined || seconds < minuteS) return words.format(0, "second");
  const [name, , length] = unit;
  return words.format(-Math.floor(seconds / length), name);
}
