// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { splitChunks, type SplitChunk } from "./split-chunks";

const grid: SplitChunk = { cost: 400, isOld: true, isInMiddle: false };
const batch: SplitChunk = { cost: 1600, isOld: true, isInMiddle: false };
const kept: SplitChunk = { ...batch, isInMiddle: true };
const fresh: SplitChunk = { ...batch, isOld: false };

describe("chunks on sheets", () => {
  it("of a small drawing need no bitmap in the middle", () => {
    const [from, to] = splitChunks([grid, batch, batch]);
    expect(to - from).toBe(0);
  });

  it("lie in the middle but for the grid and what is at the top", () => {
    const many = [grid, ...Array<SplitChunk>(30).fill(batch)];
    expect(splitChunks(many)).toEqual([1, 29]);
  });

  it("stay in the middle once they are there", () => {
    expect(splitChunks([grid, kept, kept, batch])).toEqual([1, 3]);
    expect(splitChunks([kept, batch])).toEqual([0, 1]);
  });

  it("that have just changed stay at the top, though they are many", () => {
    expect(splitChunks([grid, kept, batch, fresh, fresh, fresh])).toEqual([1, 2]);
  });

  it("that come between those in the middle lie there too", () => {
    expect(splitChunks([grid, kept, fresh, kept])).toEqual([1, 4]);
  });
});
