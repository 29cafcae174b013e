// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { gapAt, neighbouringGap, placeFromBack } from "./part-order";

/** What the core does with move_part, on a list that has the nearest on top. */
function moved(rows: readonly string[], from: number, place: number): string[] {
  const fromBack = [...rows].reverse();
  const [row] = fromBack.splice(rows.length - 1 - from, 1);
  if (row !== undefined) fromBack.splice(place, 0, row);
  return fromBack.reverse();
}

describe("the gap under a dragged row", () => {
  const middles = [20, 60, 100];

  it("is before the first row whose middle lies below", () => {
    expect(gapAt(middles, 10)).toBe(0);
    expect(gapAt(middles, 59)).toBe(1);
    expect(gapAt(middles, 61)).toBe(2);
  });

  it("is the end below the last", () => {
    expect(gapAt(middles, 1000)).toBe(3);
    expect(gapAt([], 0)).toBe(0);
  });
});

describe("the place of a row that falls into a gap", () => {
  const rows = ["near", "second", "third", "far"];

  it("puts the row exactly where the line was shown, from each row into each gap", () => {
    for (let from = 0; from < rows.length; ++from) {
      for (let gap = 0; gap <= rows.length; ++gap) {
        const marked: string[] = rows.map((row, index) => (index === from ? "gone" : row));
        marked.splice(gap, 0, rows[from] ?? "");
        const wanted = marked.filter((row) => row !== "gone");
        const place = placeFromBack(rows.length, from, gap);
        expect(place === null ? rows : moved(rows, from, place)).toEqual(wanted);
      }
    }
  });

  it("is none on either side of the row itself", () => {
    expect(placeFromBack(4, 2, 2)).toBeNull();
    expect(placeFromBack(4, 2, 3)).toBeNull();
  });
});

describe("a row moved by one", () => {
  it("changes places with its neighbour", () => {
    const rows = ["near", "second", "far"];
    const nearer = placeFromBack(3, 1, neighbouringGap(3, 1, "nearer") ?? -1);
    const farther = placeFromBack(3, 1, neighbouringGap(3, 1, "farther") ?? -1);
    expect(moved(rows, 1, nearer ?? -1)).toEqual(["second", "near", "far"]);
    expect(moved(rows, 1, farther ?? -1)).toEqual(["near", "far", "second"]);
  });

  it("has no gap beyond the ends", () => {
    expect(neighbouringGap(3, 0, "nearer")).toBeNull();
    expect(neighbouringGap(3, 2, "farther")).toBeNull();
  });
});
