// SPDX-License-Identifier: Apache-2.0

/** How the flat drawing becomes the model, as a function of time alone: STUDIO.md, Motion. */

const moveMs = 300;
const popMs = 260;
const longestStepMs = 40;
/** All of it, however many parts there are. */
const longestMs = 500;
const fallMs = 240;
/** How far a part swells beyond its height before it settles, as a bubble does. */
const swell = 1.1;

const clamped = (x: number): number => Math.min(Math.max(x, 0), 1);
const easeOut = (x: number): number => 1 - (1 - clamped(x)) ** 3;

/** Ease-out that overshoots a little. source: Penner 2001, back */
function bubble(x: number): number {
  const left = clamped(x) - 1;
  return 1 + left * left * ((swell + 1) * left + swell);
}

function stepMs(partCount: number): number {
  return partCount > 1 ? Math.min(longestStepMs, (longestMs - popMs) / (partCount - 1)) : 0;
}

/** How long a model of so many parts takes to rise. */
export function riseMs(partCount: number): number {
  return Math.max(moveMs, popMs + stepMs(partCount) * Math.max(partCount - 1, 0));
}

/** How far the model has gone from the paper to its place. 0 .. 1 */
export function moveShare(riseTimeMs: number): number {
  return easeOut(riseTimeMs / moveMs);
}

/** How high a part stands: 0 flat, 1 as it is; part 0 is at the back and the first. */
export function inflation(riseTimeMs: number, part: number, partCount: number): number {
  return bubble((riseTimeMs - part * stepMs(partCount)) / popMs);
}

export type Direction = "rise" | "fall";

/** A motion under way: what it began with, so that one can turn into the other in its midst. */
export interface Motion {
  readonly direction: Direction;
  /** Where on the way of a rise it began, ms. */
  readonly fromMs: number;
  readonly partCount: number;
}

/** Where on the way of a rise a motion has come after a time: a fall goes back the same way, sooner. */
export function riseTime(motion: Motion, elapsedMs: number): number {
  if (motion.direction === "rise") {
    return Math.min(motion.fromMs + elapsedMs, riseMs(motion.partCount));
  }
  return motion.fromMs * (1 - easeOut(elapsedMs / fallMs));
}

export function isOver(motion: Motion, elapsedMs: number): boolean {
  if (motion.direction === "rise") return motion.fromMs + elapsedMs >= riseMs(motion.partCount);
  return elapsedMs >= fallMs;
}
