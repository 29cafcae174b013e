// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "../protocol/actions.generated";
import type { ActionRow, Language } from "../protocol/state";

/** One line of the palette: an action, or one of its choices. */
export interface PaletteEntry {
  readonly id: string;
  readonly action: ActionName;
  /** What it is done with; null: nothing, or it is asked for. */
  readonly choice: string | null;
  readonly asksFor: "number" | "text" | null;
  /** Its words, the person's language first. */
  readonly labels: readonly string[];
}

/** They need a place on the canvas, a colour or numbers that only other surfaces know. */
const leftOut: readonly ActionName[] = ["palette", "cancel", "select", "move_part", "show_place"];

/** What comes first while nothing is typed: the way of a drawing, and nothing that puts it away. */
const likely: readonly ActionName[] = [
  "simplify",
  "mode_inflate",
  "mode_draw",
  "export",
  "zoom_fit",
  "undo",
];

function likeliness(action: ActionName): number {
  const place = likely.indexOf(action);
  return place === -1 ? likely.length : place;
}

/** Lines of the palette. choiceLabel: what a choice is called, in a language. */
export function paletteEntries(
  actions: readonly ActionRow[],
  language: Language,
  choiceLabel: (choice: string, language: Language) => string,
): PaletteEntry[] {
  const order: readonly Language[] = language === "en" ? ["en", "cs"] : ["cs", "en"];
  return actions.flatMap((row): PaletteEntry[] => {
    if (leftOut.includes(row.name)) return [];
    const labels = order.map((each) => row.labels[each]);
    const entry = { id: row.name, action: row.name, choice: null, asksFor: null, labels };
    switch (row.argument) {
      case "none":
        return [entry];
      case "number":
      case "text":
        return [{ ...entry, asksFor: row.argument }];
      case "choice":
        return row.choices.map((choice) => ({
          ...entry,
          id: `${row.name}-${choice}`,
          choice,
          labels: order.map((each) => `${row.labels[each]}: ${choiceLabel(choice, each)}`),
        }));
      case "colour":
      case "place":
        return [];
    }
  });
}

/** Without case and accents: "Mřížka" is found by "mriz". */
export function folded(text: string): string {
  return text
    .normalize("NFD")
    .replace(/\p{Diacritic}/gu, "")
    .toLowerCase();
}

/** How well a label has what was typed; 0: it has not all of it. */
function labelScore(label: string, typed: readonly string[]): number {
  const words = label.split(/[^\p{Letter}\p{Number}]+/u);
  let score = 0;
  for (const part of typed) {
    if (words.includes(part)) score += 4;
    else if (words.some((word) => word.startsWith(part))) score += 3;
    else if (label.includes(part)) score += 1;
    else return 0;
  }
  // The start of the label is what one types first.
  return label.startsWith(typed.join(" ")) ? score + 2 : score;
}

function entryScore(entry: PaletteEntry, typed: readonly string[]): number {
  const scores = entry.labels.map((label, index) => {
    const score = labelScore(folded(label), typed);
    // A little less for the other language.
    return index === 0 ? score : score * 0.9;
  });
  return Math.max(0, ...scores);
}

/** The lines that have every word that was typed, the best first; all of them while nothing is typed. */
export function findEntries(
  entries: readonly PaletteEntry[],
  query: string,
  isEnabled: (action: ActionName) => boolean,
): PaletteEntry[] {
  const typed = folded(query).split(/\s+/).filter(Boolean);
  const enabledFirst = (a: PaletteEntry, b: PaletteEntry) =>
    Number(isEnabled(b.action)) - Number(isEnabled(a.action));
  if (typed.length === 0) {
    const likelyFirst = (a: PaletteEntry, b: PaletteEntry) =>
      likeliness(a.action) - likeliness(b.action);
    return [...entries].sort((a, b) => enabledFirst(a, b) || likelyFirst(a, b));
  }
  return entries
    .map((entry) => ({ entry, score: entryScore(entry, typed) }))
    .filter(({ score }) => score > 0)
    .sort((a, b) => b.score - a.score || enabledFirst(a.entry, b.entry))
    .map(({ entry }) => entry);
}
