// SPDX-License-Identifier: Apache-2.0
import { expect, test } from "vitest";
import { chordText, isApple } from "./chords";

test("keys are written as people of the system write them", () => {
  expect(chordText("Ctrl+Shift+Z", false)).toBe("Ctrl+Shift+Z");
  expect(chordText("Ctrl+Shift+Z", true)).toBe("⌘⇧Z");
  expect(chordText("ArrowLeft", false)).toBe("←");
  expect(chordText("", false)).toBe("");
});

test("plus is a key too", () => {
  expect(chordText("+", false)).toBe("+");
  expect(chordText("Ctrl++", true)).toBe("⌘+");
});

test("Apple's systems are known by their names", () => {
  expect(["MacIntel", "iPad", "Linux x86_64", "Win32"].map(isApple)).toEqual([
    true,
    true,
    false,
    false,
  ]);
});
