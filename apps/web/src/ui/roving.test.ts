// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { nextIndex } from "./roving";

describe("arrows in a row of items", () => {
  it("go on from the last to the first and back", () => {
    expect(nextIndex("ArrowRight", 2, 3, "horizontal")).toBe(0);
    expect(nextIndex("ArrowLeft", 0, 3, "horizontal")).toBe(2);
  });

  it("across the row are left to others", () => {
    expect(nextIndex("ArrowDown", 0, 3, "horizontal")).toBeNull();
    expect(nextIndex("ArrowRight", 0, 3, "vertical")).toBeNull();
  });

  it("go both ways where the row may stand or lie", () => {
    expect(nextIndex("ArrowDown", 0, 3, "both")).toBe(1);
    expect(nextIndex("ArrowRight", 0, 3, "both")).toBe(1);
  });

  it("leave Home and End to reach the ends, from anywhere", () => {
    expect(nextIndex("Home", 1, 3, "vertical")).toBe(0);
    expect(nextIndex("End", 1, 3, "vertical")).toBe(2);
  });

  it("leave keys that move nothing, and rows with nothing in them", () => {
    expect(nextIndex("a", 1, 3, "both")).toBeNull();
    expect(nextIndex("Home", 0, 0, "both")).toBeNull();
  });
});
