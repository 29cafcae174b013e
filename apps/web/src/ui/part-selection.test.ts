// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { selectArgument, selectionAfterClick } from "./part-selection";

const rows = [5, 4, 3, 2, 1];
const plain = { isRange: false, isToggle: false };

describe("a click on a row", () => {
  it("selects that row alone", () => {
    expect(selectionAfterClick(rows, [1, 2], 1, { id: 4, ...plain })).toEqual([4]);
  });

  it("adds with Ctrl, and takes away what was selected", () => {
    expect(selectionAfterClick(rows, [1], 1, { id: 4, ...plain, isToggle: true })).toEqual([1, 4]);
    expect(selectionAfterClick(rows, [1, 4], 1, { id: 4, ...plain, isToggle: true })).toEqual([1]);
  });

  it("selects everything between with Shift, whichever way", () => {
    const range = { ...plain, isRange: true };
    expect(selectionAfterClick(rows, [4], 4, { id: 2, ...range })).toEqual([4, 3, 2]);
    expect(selectionAfterClick(rows, [2], 2, { id: 4, ...range })).toEqual([4, 3, 2]);
  });

  it("selects that row alone with Shift when the row before has gone", () => {
    expect(selectionAfterClick(rows, [], 9, { id: 2, ...plain, isRange: true })).toEqual([2]);
    expect(selectionAfterClick(rows, [], null, { id: 2, ...plain, isRange: true })).toEqual([2]);
  });
});

describe("the argument of select", () => {
  it("lists ids, and nothing for none", () => {
    expect(selectArgument([3, 1])).toBe("3 1");
    expect(selectArgument([])).toBe("");
  });
});
