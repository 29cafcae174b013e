// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { ownUrl } from "./trusted-urls";

const page = "https://example.org/studio/index.html";

describe("ownUrl", () => {
  it("resolves addresses of this site", () => {
    expect(ownUrl("./sw.js", page)).toBe("https://example.org/studio/sw.js");
    expect(ownUrl("/core.js", page)).toBe("https://example.org/core.js");
  });

  it.each([
    "https://example.com/sw.js",
    "//example.com/sw.js",
    "http://example.org/sw.js",
    "data:text/javascript,0",
    "blob:https://example.org/1",
    "javascript:0",
  ])("lets nothing else through: %s", (url) => {
    expect(() => ownUrl(url, page)).toThrow();
  });
});
