// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import type { ActionName } from "../protocol/actions.generated";
import type { ActionRow } from "../protocol/state";
import { findEntries, folded, paletteEntries } from "./palette-search";

function row(
  name: ActionName,
  en: string,
  cs: string,
  argument: ActionRow["argument"] = "none",
  choices: readonly string[] = [],
): ActionRow {
  return { name, menu: "edit", labels: { en, cs }, chords: [], argument, choices };
}

const actions = [
  row("flip_horizontal", "Flip horizontally", "Překlopit vodorovně"),
  row("grid", "Grid", "Mřížka"),
  row("mirror_view", "Mirror view", "Zrcadlit pohled"),
  row("zoom_in", "Zoom in", "Přiblížit"),
  row("mode_inflate", "Inflate", "Nafouknout"),
  row("thickness", "Thickness", "Tloušťka", "number"),
  row("fill", "Fill colour", "Barva výplně", "colour"),
  row("mark_inside", "Mark as inside", "Označit jako vnitřek", "place"),
  row("select", "Select parts", "Vybrat části", "text"),
  row("look", "Look", "Vzhled", "choice", ["matcap", "lines"]),
];
const english = paletteEntries(actions, "en", (choice) => choice);
const always = () => true;
const found = (query: string, isEnabled: (action: ActionName) => boolean = always) =>
  findEntries(english, query, isEnabled).map((entry) => entry.id);

describe("the palette's lines", () => {
  it("leave out what needs a place or a colour, and what only other surfaces can say", () => {
    const names = english.map((entry) => entry.action);
    expect(names).not.toContain("fill");
    expect(names).not.toContain("mark_inside");
    expect(names).not.toContain("select");
  });

  it("ask for a number, and have a line for each choice", () => {
    expect(english.find((entry) => entry.action === "thickness")?.asksFor).toBe("number");
    expect(found("look")).toEqual(["look-matcap", "look-lines"]);
  });

  it("begin with the words of the person's language", () => {
    const czech = paletteEntries(actions, "cs", (choice) => choice);
    expect(czech[1]?.labels).toEqual(["Mřížka", "Grid"]);
  });
});

describe("finding an action", () => {
  it("shows everything while nothing is typed, what can be done now first", () => {
    const ids = found("", (action) => action === "zoom_in");
    expect(ids[0]).toBe("zoom_in");
    expect(ids).toHaveLength(english.length);
  });

  it("begins with the next step of a drawing while nothing is typed", () => {
    expect(found("")[0]).toBe("mode_inflate");
  });

  it("finds it by the beginning of any of its words, in any order", () => {
    expect(found("hor")).toEqual(["flip_horizontal"]);
    expect(found("hor fl")).toEqual(["flip_horizontal"]);
  });

  it("finds it in the other language, without accents", () => {
    expect(found("mriz")).toEqual(["grid"]);
    expect(found("Nafouk")).toEqual(["mode_inflate"]);
  });

  it("puts the beginning of a label first, then a word, then the midst of one", () => {
    expect(found("in")).toEqual(["mode_inflate", "zoom_in", "look-lines"]);
  });

  it("finds nothing when one of the words is nowhere", () => {
    expect(found("flip sideways")).toEqual([]);
  });
});

describe("folding", () => {
  it("takes away case and accents alone", () => {
    expect(folded("Příliš Žluťoučký 3MF")).toBe("prilis zlutoucky 3mf");
  });
});
