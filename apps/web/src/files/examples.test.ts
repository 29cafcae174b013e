// SPDX-License-Identifier: Apache-2.0
import { existsSync } from "node:fs";
import { describe, expect, it } from "vitest";
import words from "../../../words.json";
import { examples } from "./examples";
import list from "./examples.json";

describe("the examples", () => {
  it("have a name in the table of words", () => {
    for (const { name } of examples) expect(words[name]).toBeDefined();
  });

  it("are drawings of ours", () => {
    for (const { folder, name } of list) {
      const drawing = new URL(`../../../../examples/${folder}/${name}.svg`, import.meta.url);
      expect(existsSync(drawing), drawing.pathname).toBe(true);
    }
  });

  it("are each there once, and three are rough", () => {
    expect(new Set(examples.map(({ id }) => id)).size).toBe(examples.length);
    expect(examples.filter(({ isRough }) => isRough).length).toBe(3);
  });
});
