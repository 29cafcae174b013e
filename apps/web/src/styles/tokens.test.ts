// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";

const css = readFileSync(new URL("tokens.css", import.meta.url), "utf8");

type Theme = ReadonlyMap<string, string>;

/** The colours of one block of the file, by the name of the property. */
function theme(opening: string): Theme {
  const start = css.indexOf(opening);
  const block = css.slice(start, css.indexOf("}", start));
  const rows = [...block.matchAll(/--([a-z-]+): (#[0-9a-f]{6});/g)];
  return new Map(rows.map(([, name = "", value = ""]) => [name, value]));
}

function luminance(hex: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => {
    const value = parseInt(hex.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

function contrast(one: string, other: string): number {
  const [dark = 0, light = 0] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (light + 0.05) / (dark + 0.05);
}

const themes = {
  light: theme(":root {"),
  "dark by system": theme(':root:not([data-theme="light"]) {'),
  "dark by choice": theme(':root[data-theme="dark"] {'),
};

const grounds = ["chrome", "chrome-raised"];
const texts = ["ink", "ink-soft", "danger", "warning", "good"];
const marks = ["line-strong", "focus", "accent"];

function pairs(fronts: readonly string[]): (readonly [string, string])[] {
  return fronts.flatMap((front) => grounds.map((ground) => [front, ground] as const));
}

describe.each(Object.entries(themes))("the %s theme", (_name, colours) => {
  const between = (one: string, other: string) =>
    contrast(colours.get(one) ?? "", colours.get(other) ?? "");

  it.each([...pairs(texts), ["accent-ink", "accent"], ["chosen-ink", "chosen"]] as const)(
    "has text in %s on %s at 4.5:1 or more",
    (front, ground) => {
      expect(between(front, ground)).toBeGreaterThanOrEqual(4.5);
    },
  );

  it.each(pairs(marks))("has marks in %s on %s at 3:1 or more", (front, ground) => {
    expect(between(front, ground)).toBeGreaterThanOrEqual(3);
  });

  it.each([
    ["accent-ink", "accent-hover"],
    ["accent-ink", "accent-pressed"],
  ] as const)("keeps text in %s readable on %s", (front, ground) => {
    expect(between(front, ground)).toBeGreaterThanOrEqual(4.5);
  });
});

it("is the same dark theme by system and by choice", () => {
  expect([...themes["dark by system"]]).toEqual([...themes["dark by choice"]]);
});

it.each([
  ["light", ":root {"],
  ["grey", ':root[data-theme="dark"][data-paper="slate"] {'],
])("has readable words on %s paper", (_name, opening) => {
  const paper = new Map([...themes.light, ...theme(opening)]);
  for (const ink of ["paper-ink", "paper-ink-soft"]) {
    expect(contrast(paper.get(ink) ?? "", paper.get("paper") ?? "")).toBeGreaterThanOrEqual(4.5);
  }
});
