// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import type { ActionRow } from "../protocol/state";
import { keyGroups } from "./key-groups";

const base = { argument: "none", choices: [] } as const;
const actions: readonly ActionRow[] = [
  { ...base, name: "undo", menu: "edit", labels: { en: "Undo", cs: "Zpět" }, chords: ["Ctrl+Z"] },
  { ...base, name: "grid", menu: "view", labels: { en: "Grid", cs: "Mřížka" }, chords: [] },
  { ...base, name: "brush", menu: "tool", labels: { en: "Brush", cs: "Štětec" }, chords: ["B"] },
  {
    ...base,
    name: "delete",
    menu: "edit",
    labels: { en: "Delete", cs: "Smazat" },
    chords: ["Delete"],
  },
];
const names = (query: string) =>
  keyGroups(actions, query, "cs").map(({ menu, rows }) => [menu, rows.map((row) => row.name)]);

describe("the list of keys", () => {
  it("has each action with a key, under its menu", () => {
    expect(names("")).toEqual([
      ["edit", ["undo", "delete"]],
      ["tool", ["brush"]],
    ]);
  });

  it("finds by name without accents, and by key", () => {
    expect(names("stet")).toEqual([["tool", ["brush"]]]);
    expect(names("ctrl+z")).toEqual([["edit", ["undo"]]]);
  });

  it("is empty when nothing has what was typed", () => {
    expect(names("xyzzy")).toEqual([]);
  });
});
