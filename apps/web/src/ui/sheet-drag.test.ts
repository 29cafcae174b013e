// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { sheetAfterDrag } from "./sheet-drag";

describe("a sheet whose handle is let go", () => {
  it("stays where it was after a small slow move", () => {
    expect(sheetAfterDrag("short", 20, 0.1)).toBe("short");
    expect(sheetAfterDrag("tall", -20, -0.1)).toBe("tall");
  });

  it("becomes tall when drawn up", () => {
    expect(sheetAfterDrag("short", -80, -0.1)).toBe("tall");
  });

  it("goes down one step at a time", () => {
    expect(sheetAfterDrag("tall", 80, 0.1)).toBe("short");
    expect(sheetAfterDrag("short", 80, 0.1)).toBe("closed");
  });

  it("follows a flick, however short and whichever way it went before", () => {
    expect(sheetAfterDrag("short", 10, 1)).toBe("closed");
    expect(sheetAfterDrag("short", 80, -1)).toBe("tall");
  });
});
