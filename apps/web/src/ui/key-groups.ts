// SPDX-License-Identifier: Apache-2.0
import type { ActionRow, Language, Menu } from "../protocol/state";
import { folded } from "./palette-search";

export interface KeyGroup {
  readonly menu: Menu;
  readonly rows: readonly ActionRow[];
}

/** All actions that have a key, by menu; those alone that have what was typed in their name or keys. */
export function keyGroups(
  actions: readonly ActionRow[],
  query: string,
  language: Language,
): KeyGroup[] {
  const typed = folded(query.trim());
  const groups = new Map<Menu, ActionRow[]>();
  for (const row of actions) {
    if (row.chords.length === 0) continue;
    const text = folded([row.labels[language], ...row.chords].join(" "));
    if (!text.includes(typed)) continue;
    groups.set(row.menu, [...(groups.get(row.menu) ?? []), row]);
  }
  return [...groups].map(([menu, rows]) => ({ menu, rows }));
}
