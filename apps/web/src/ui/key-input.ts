// SPDX-License-Identifier: Apache-2.0
import type { ActionRow } from "../protocol/state";

/** Of a KeyboardEvent, what says which key it is. */
export interface PressedKey {
  readonly key: string;
  readonly code: string;
  readonly shiftKey: boolean;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly altKey: boolean;
}

/** All keys of the core's table, as spelled there, letters small. */
export function keysOf(actions: readonly ActionRow[]): ReadonlySet<string> {
  return new Set(actions.flatMap((row) => row.chords.map(normal)));
}

function normal(chord: string): string {
  return chord.replace(/(^|\+)([A-Z])$/, (_all, plus: string, letter: string) => {
    return plus + letter.toLowerCase();
  });
}

/** The key as the core names it. A digit row that types accents (Czech) still has the digits that the table wants. */
export function coreKey(event: PressedKey, keys: ReadonlySet<string>): string {
  const digit = /^Digit(\d)$/.exec(event.code)?.[1];
  if (digit === undefined || event.shiftKey || event.altKey) return event.key;
  return keys.has(digit) || keys.has(`Ctrl+${digit}`) ? digit : event.key;
}

/** Whether the table has the key; a sign may be typed with Shift on one keyboard and without on another. */
export function isCoreKey(event: PressedKey, isApple: boolean, keys: ReadonlySet<string>): boolean {
  const key = coreKey(event, keys);
  const isLetter = /^[a-z]$/i.test(key);
  const isCtrl = isApple ? event.metaKey : event.ctrlKey;
  const before = (isCtrl ? "Ctrl+" : "") + (event.altKey ? "Alt+" : "");
  const plain = isLetter ? key.toLowerCase() : key;
  const withShift = before + (event.shiftKey ? "Shift+" : "") + plain;
  return keys.has(withShift) || (!isLetter && keys.has(before + plain));
}

/** What the element with the focus does with keys by itself. */
export type KeyOwner = "none" | "text" | "slider" | "button" | "list";

const sliderKeys = /^(Arrow|Home$|End$|Page)/;
/** What one does while writing, by Ctrl. */
const writingKeys = /^[acvxyz]$/i;

/** Whether the key is the focused element's own, and the core is not told. */
export function isOwnKey(event: PressedKey, owner: KeyOwner): boolean {
  if (event.key === "Tab") return true;
  const isCtrl = event.ctrlKey || event.metaKey;
  switch (owner) {
    case "none":
      return false;
    case "text":
      return !isCtrl || writingKeys.test(event.key) || event.key.length > 1;
    case "list":
      return !isCtrl;
    case "slider":
      return sliderKeys.test(event.key);
    case "button":
      return event.key === "Enter" || event.key === " ";
  }
}
