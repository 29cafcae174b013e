// SPDX-License-Identifier: Apache-2.0

/** What the core allows: src/document/check_values.h. */
export const leastThickness = 0.1;
export const mostThickness = 32;
/** Of the slider. */
export const thicknessSteps = 100;

/** Twice as thick is the same way on the slider everywhere: thin parts need the fine steps. */
export function thicknessAt(step: number): number {
  const share = Math.min(1, Math.max(0, step / thicknessSteps));
  const exact = leastThickness * (mostThickness / leastThickness) ** share;
  return Number(exact.toPrecision(2));
}

export function stepOf(thickness: number): number {
  const bounded = Math.min(mostThickness, Math.max(leastThickness, thickness));
  const share = Math.log(bounded / leastThickness) / Math.log(mostThickness / leastThickness);
  return Math.round(share * thicknessSteps);
}
