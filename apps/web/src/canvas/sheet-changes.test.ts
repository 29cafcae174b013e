// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { sheetChanges } from "./sheet-changes";

describe("changes of a sheet", () => {
  it("tell what comes over all that stays from what comes between", () => {
    expect(sheetChanges(["a", "b", "c"], ["a", "x", "c", "y"])).toEqual({
      removed: ["b"],
      inserted: ["x"],
      below: ["a", "x", "c"],
      appended: ["y"],
    });
  });

  it("are none where all is the same", () => {
    expect(sheetChanges(["a"], ["a"])).toEqual({
      removed: [],
      inserted: [],
      below: ["a"],
      appended: [],
    });
  });

  it("cannot be told when the order is another", () => {
    expect(sheetChanges(["a", "b"], ["b", "a"])).toBeNull();
  });
});
