// SPDX-License-Identifier: Apache-2.0
import table from "../../../words.json";
import type { Language } from "../protocol/state";

/** A row of apps/words.json, the words of all studios that the core does not say itself. */
export type Word = keyof typeof table;

/** The word in a language; {0}, {1} are replaced by the arguments. */
export function word(name: Word, language: Language, ...values: (string | number)[]): string {
  return table[name][language].replace(/\{(\d)\}/g, (whole, index: string) =>
    String(values[Number(index)] ?? whole),
  );
}
