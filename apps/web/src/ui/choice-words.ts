// SPDX-License-Identifier: Apache-2.0
import { word, type Word } from "../studio/words";
import type { Language } from "../protocol/state";

const words: Readonly<Record<string, Word>> = {
  matcap: "look_clay",
  textured: "look_drawing",
  lines: "look_lines",
  body: "bend_body",
  wire: "as_strip",
  en: "language_english",
  cs: "language_czech",
  on: "on",
  off: "off",
};

/** What a choice of an action is called; formats of files have their own names. */
export function choiceLabel(choice: string, language: Language): string {
  const name = words[choice];
  return name === undefined ? choice.toUpperCase() : word(name, language);
}
