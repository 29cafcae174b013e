// SPDX-License-Identifier: Apache-2.0

export interface SplitChunk {
  /** About how many points have to be drawn. */
  readonly cost: number;
  /** It was in the scene before this one. */
  readonly isOld: boolean;
  /** It lies on the middle sheet. */
  readonly isInMiddle: boolean;
}

/** What can be painted in each frame at the bottom: the paper's grid changes wherever the camera goes. */
const mostGround = 1500;
/** At the top, where the next stroke comes: a batch of strokes or two. */
const mostTop = 4000;
/** What has just changed is about to change again: so much is painted in each frame rather than to spoil the middle sheet. */
const mostChanging = 12_000;

/** Which chunks the middle sheet should keep: from the first to before the second index. Those before lie on the ground, those after on top. */
export function splitChunks(chunks: readonly SplitChunk[]): readonly [number, number] {
  let from = 0;
  let cost = 0;
  for (const chunk of chunks) {
    cost += chunk.cost;
    if (chunk.isInMiddle || cost > mostGround) break;
    ++from;
  }
  let to = chunks.length;
  const costs = { old: 0, changing: 0 };
  for (const chunk of chunks.slice(from).reverse()) {
    costs[chunk.isOld ? "old" : "changing"] += chunk.cost;
    if (chunk.isInMiddle || costs.old > mostTop || costs.changing > mostChanging) break;
    --to;
  }
  return [from, to];
}
