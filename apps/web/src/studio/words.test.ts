// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from "vitest";
import table from "../../../words.json";

const sources = import.meta.glob<string>(
  ["../**/*.{ts,tsx}", "../files/examples.json", "!../**/*.test.ts"],
  { query: "?raw", import: "default", eager: true },
);
const code = Object.values(sources).join("\n");

function holesOf(text: string): string[] {
  return [...text.matchAll(/\{\d\}/g)].map(([hole]) => hole).sort();
}

describe.each(Object.entries(table))("the word %s", (key, row) => {
  test("is said somewhere", () => {
    // Names of examples are put together from their list.
    const names = [key, key.replace(/^example_/, "")];
    expect(names.some((name) => code.includes(`"${name}"`))).toBe(true);
  });

  test("holds the same in both languages", () => {
    expect(holesOf(row.en)).toEqual(holesOf(row.cs));
  });
});
