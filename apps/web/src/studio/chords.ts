// SPDX-License-Identifier: Apache-2.0

const signs: Readonly<Record<string, string>> = {
  Ctrl: "⌘",
  Shift: "⇧",
  Alt: "⌥",
  Enter: "↩",
  Delete: "⌦",
  Backspace: "⌫",
  Escape: "⎋",
};
const arrows: Readonly<Record<string, string>> = {
  ArrowLeft: "←",
  ArrowRight: "→",
  ArrowUp: "↑",
  ArrowDown: "↓",
};

export function isApple(platform: string): boolean {
  return /mac|iphone|ipad/i.test(platform);
}

/** "Ctrl+Shift+Z" as people of this system write it. */
export function chordText(chord: string, forApple: boolean): string {
  // The last "+" of "Ctrl++" is the key.
  const keys = chord.split(/\+(?=.)/);
  const named = keys.map((key) => arrows[key] ?? (forApple ? (signs[key] ?? key) : key));
  return named.join(forApple ? "" : "+");
}
