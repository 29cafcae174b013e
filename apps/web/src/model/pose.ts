// SPDX-License-Identifier: Apache-2.0
import type { Extent } from "./extent";
import { blendPlacements } from "./blend-placements";
import { clipMatrix, depthReach, handedness, normalMatrix, raised } from "./placement";
import type { Ball, Placement, ViewSize } from "./placement";
import { inflation, moveShare } from "./rise";

/** How flat parts lie upon each other, as a share of the model's depth. */
const gapShare = 1;
/** And the front of a part upon its back. */
const sheetShare = 0.3;
/** Model px; a flat model has no depth to take a share of. */
const leastGapPx = 1;

/** How a model of some parts stands at a moment of its rise. */
export interface Pose {
  readonly size: ViewSize;
  readonly toClip: Float32Array;
  readonly turn: Float32Array;
  readonly isMirrored: boolean;
  /** px of the view from the nearest to the farthest that can be seen. */
  readonly depthPx: number;
  /** How far it has come from the paper. 0 .. 1 */
  readonly share: number;
  /** null: it stands, all of it. */
  readonly parts: ((part: number) => PartPose) | null;
}

export interface PartPose {
  readonly inflation: number;
  /** In depth alone, model px. */
  readonly liftPx: number;
  readonly sheetPx: number;
}

export const standing: PartPose = { inflation: 1, liftPx: 0, sheetPx: 0 };

export interface Way {
  readonly onPaper: Placement;
  readonly toView: Placement;
}

function poseOf(placement: Placement, ball: Ball, size: ViewSize): Omit<Pose, "share" | "parts"> {
  return {
    size,
    toClip: clipMatrix(placement, ball, size),
    turn: normalMatrix(placement),
    isMirrored: handedness(placement) < 0,
    depthPx: 2 * depthReach(placement, ball),
  };
}

export function standingPose(way: Way, extent: Extent, size: ViewSize): Pose {
  return { ...poseOf(way.toView, extent, size), share: 1, parts: null };
}

/** riseTimeMs: 0 .. riseMs(partCount) */
export function risingPose(
  way: Way,
  extent: Extent,
  partCount: number,
  size: ViewSize,
  riseTimeMs: number,
): Pose {
  const share = moveShare(riseTimeMs);
  const placement = blendPlacements(raised(way.onPaper), way.toView, extent.centre, share);
  const gap = Math.max(gapShare * 2 * extent.half[2], leastGapPx);
  const ball = { centre: extent.centre, radius: 1.2 * extent.radius + gap * (partCount + 1) };
  return {
    ...poseOf(placement, ball, size),
    share,
    parts: (part) => {
      const height = inflation(riseTimeMs, part, partCount);
      const flatness = Math.max(1 - height, 0);
      return {
        inflation: height,
        liftPx: flatness * gap * part,
        sheetPx: flatness * sheetShare * gap,
      };
    },
  };
}
