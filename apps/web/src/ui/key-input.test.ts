// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { coreKey, isCoreKey, isOwnKey, type PressedKey } from "./key-input";

const keys = new Set(["1", "2", "3", "Ctrl+0", "Ctrl+s", "b", "?", "+", "-", "PageUp", "Shift+h"]);

function pressed(key: string, change: Partial<PressedKey> = {}): PressedKey {
  const code = "";
  return { key, code, shiftKey: false, ctrlKey: false, metaKey: false, altKey: false, ...change };
}

describe("keys for the core", () => {
  it("are digits on a row that types accents", () => {
    expect(coreKey(pressed("ě", { code: "Digit2" }), keys)).toBe("2");
    expect(coreKey(pressed("+", { code: "Digit1" }), keys)).toBe("1");
    expect(coreKey(pressed("é", { code: "Digit0", ctrlKey: true }), keys)).toBe("0");
  });

  it("stay what was typed where the table wants no digit", () => {
    expect(coreKey(pressed("-", { code: "Digit6" }), keys)).toBe("-");
  });

  it("stay what was typed with Shift", () => {
    expect(coreKey(pressed("!", { code: "Digit1", shiftKey: true }), keys)).toBe("!");
  });

  it("are taken from the browser when the table has them", () => {
    expect(isCoreKey(pressed("s", { ctrlKey: true }), false, keys)).toBe(true);
    expect(isCoreKey(pressed("PageUp"), false, keys)).toBe(true);
    expect(isCoreKey(pressed("H", { shiftKey: true }), false, keys)).toBe(true);
    expect(isCoreKey(pressed("?", { shiftKey: true }), false, keys)).toBe(true);
  });

  it("are left to the browser when the table has them not", () => {
    expect(isCoreKey(pressed("c", { ctrlKey: true }), false, keys)).toBe(false);
    expect(isCoreKey(pressed("+", { ctrlKey: true }), false, keys)).toBe(false);
    expect(isCoreKey(pressed("F5"), false, keys)).toBe(false);
    expect(isCoreKey(pressed("h"), false, keys)).toBe(false);
  });

  it("count Cmd for Ctrl on Apple's systems, and there alone", () => {
    expect(isCoreKey(pressed("s", { metaKey: true }), true, keys)).toBe(true);
    expect(isCoreKey(pressed("s", { metaKey: true }), false, keys)).toBe(false);
  });
});

describe("keys of the element with the focus", () => {
  it("are all that writes, in a text", () => {
    expect(isOwnKey(pressed("b"), "text")).toBe(true);
    expect(isOwnKey(pressed("z", { ctrlKey: true }), "text")).toBe(true);
    expect(isOwnKey(pressed("ArrowLeft", { ctrlKey: true }), "text")).toBe(true);
    expect(isOwnKey(pressed("s", { ctrlKey: true }), "text")).toBe(false);
  });

  it("are those that move it, on a slider", () => {
    expect(isOwnKey(pressed("ArrowLeft"), "slider")).toBe(true);
    expect(isOwnKey(pressed("PageUp"), "slider")).toBe(true);
    expect(isOwnKey(pressed("Enter"), "slider")).toBe(false);
  });

  it("are those that press it, on a button", () => {
    expect(isOwnKey(pressed("Enter"), "button")).toBe(true);
    expect(isOwnKey(pressed(" "), "button")).toBe(true);
    expect(isOwnKey(pressed("b"), "button")).toBe(false);
  });

  it("are all without Ctrl, in a menu", () => {
    expect(isOwnKey(pressed("b"), "list")).toBe(true);
    expect(isOwnKey(pressed("s", { ctrlKey: true }), "list")).toBe(false);
  });

  it("are none on the drawing but Tab", () => {
    expect(isOwnKey(pressed(" "), "none")).toBe(false);
    expect(isOwnKey(pressed("Tab"), "none")).toBe(true);
  });
});
