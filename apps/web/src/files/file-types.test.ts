// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { exportFormats, sizeText } from "./export-formats";
import { acceptedFor, extensionOf, isPicture, mimeTypeOf, stemOf } from "./file-types";

describe("names of files", () => {
  it.each([
    ["Mouse.SVG", ".svg", "Mouse"],
    ["a.b.inkflate", ".inkflate", "a.b"],
    ["plain", "", "plain"],
    [".svg", ".svg", ".svg"],
    ["folder.d/plain", "", "folder.d/plain"],
  ])("%s: extension %s, stem %s", (name, extension, stem) => {
    expect([extensionOf(name), stemOf(name)]).toEqual([extension, stem]);
  });

  it("tell pictures where the system names no type", () => {
    expect(isPicture({ name: "scan.JPG", type: "" })).toBe(true);
    expect(isPicture({ name: "scan.inkflate", type: "" })).toBe(false);
  });
});

describe("types of files", () => {
  it("tell pictures from drawings", () => {
    expect(isPicture({ name: "x", type: "image/webp" })).toBe(true);
    expect(isPicture({ name: "x.png", type: "image/svg+xml" })).toBe(false);
  });

  it("let only pictures be a reference picture", () => {
    expect(Object.values(acceptedFor("template")).flat()).toEqual([".png", ".jpg", ".jpeg"]);
  });

  it("are known for all that is exported", () => {
    for (const { extension } of exportFormats) {
      expect(mimeTypeOf(`drawing.${extension}`)).not.toBe("application/octet-stream");
    }
  });
});

describe("sizeText", () => {
  it.each([
    [1, "1 kB"],
    [340_100, "340 kB"],
    [1_440_000, "1.4 MB"],
    [64_000_000, "64 MB"],
  ])("%i bytes are %s", (bytes, text) => {
    expect(sizeText(bytes, "en")).toBe(text);
  });

  it("writes numbers as the language does", () => {
    expect(sizeText(1_440_000, "cs")).toMatch(/^1,4\sMB$/);
  });
});
