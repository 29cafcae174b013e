// SPDX-License-Identifier: Apache-2.0
import type { Word } from "../studio/words";

/** The core tells its steps in an engineer's words; several of them are one thing to the person. */
const stages: readonly (readonly [Word, readonly string[]])[] = [
  ["stage_scan", ["paper", "ink", "lines"]],
  [
    "stage_simplify",
    [
      ...["triangulate", "cut", "holes", "trace", "sample", "centre", "mouths", "fit", "sort"],
      ...["place", "draw strokes on pixels", "cut pixels", "trace pixels"],
    ],
  ],
  ["stage_bend", ["bend"]],
  ["stage_join", ["join", "mesh", "stitch"]],
  ["stage_inflate", ["inflate", "order", "shape"]],
  ["stage_texture", ["texture"]],
  [
    "stage_solid",
    [
      ...["lay into the lattice", "scan lines", "thicken", "tell inside from outside"],
      ...["cut edges", "move nodes", "march", "smooth creases"],
    ],
  ],
  ["stage_write", ["write"]],
];

/** What the person reads while the core is at a stage. */
export function stageWord(stage: string): Word {
  return stages.find(([, names]) => names.includes(stage))?.[0] ?? "stage_other";
}
