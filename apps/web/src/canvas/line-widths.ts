// SPDX-License-Identifier: Apache-2.0
import type { StrokedPolyline } from "../protocol/draw-list";

/** Widths and dashes of a line as they are at some scale, in px of its list. */
export interface LineWidths {
  /** One for the whole line, or one for each point. */
  readonly widths: Float32Array;
  readonly dashes: Float32Array;
}

type LimitedLine = Pick<StrokedPolyline, "widths" | "dashes" | "leastPx" | "mostPx">;

/** Widths that differ by less than this share of the largest are one width. */
const sameWidthShare = 1e-3;

/** One width where all are the same: a canvas strokes such a line by itself. */
function withoutRepeats(widths: Float32Array): Float32Array {
  let least = Infinity;
  let most = -Infinity;
  for (const width of widths) {
    least = Math.min(least, width);
    most = Math.max(most, width);
  }
  return most - least <= sameWidthShare * most ? widths.slice(0, 1) : widths;
}

/** Is it as wide as its list says at this scale? Then what was made of it serves at any such scale. */
export function isWithinLimits(line: LimitedLine, scale: number): boolean {
  return line.widths.every((width) => {
    const px = width * scale;
    return px >= line.leastPx && px <= line.mostPx;
  });
}

/**
 * The line within its limits where lengths grow by a scale: as within_limits in src/render/rasterise.cpp has it, so that both
 * renderers agree. Dashes keep their proportions where the line gets another width.
 */
export function widthsAt(line: LimitedLine, scale: number): LineWidths {
  let widest = 0;
  let widestWithin = 0;
  const widths = line.widths.map((width) => {
    const within = Math.max(Math.min(width * scale, line.mostPx), line.leastPx) / scale;
    widest = Math.max(widest, width);
    widestWithin = Math.max(widestWithin, within);
    return within;
  });
  const factor = widest > 0 ? widestWithin / widest : 1;
  return { widths: withoutRepeats(widths), dashes: line.dashes.map((dash) => dash * factor) };
}
