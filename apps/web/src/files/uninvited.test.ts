// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { receptionOf } from "./uninvited";

describe("a file that nobody asked for", () => {
  it("never takes the place of what is drawn", () => {
    expect(receptionOf({ isPicture: false, isBlank: false }).use).toBe("add");
    expect(receptionOf({ isPicture: true, isBlank: false }).use).toBe("template");
  });

  it("is opened where nothing is drawn", () => {
    expect(receptionOf({ isPicture: false, isBlank: true })).toEqual({ use: "open", offer: null });
    expect(receptionOf({ isPicture: true, isBlank: true }).use).toBe("open");
  });

  it.each([
    [true, true],
    [true, false],
    [false, false],
  ])("can be used in another way (picture: %s, blank: %s)", (isPicture, isBlank) => {
    const { use, offer } = receptionOf({ isPicture, isBlank });
    expect(offer?.use).toBeDefined();
    expect(offer?.use).not.toBe(use);
  });
});
