// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import {
  assembleGenerations,
  makeLine,
  rawBytes,
  readDescription,
  readLine,
  readSessionRecord,
  type FoundLine,
  type LineKey,
} from "./records";
import { bytesOf, textOf } from "./store-in-test";

const odd: unknown[] = [
  undefined,
  null,
  true,
  0,
  -1,
  1.5,
  NaN,
  Infinity,
  2 ** 60,
  "text",
  [],
  {},
  new Date(0),
  new Float64Array(3),
  new ArrayBuffer(8),
];

const record = { created: 1, changed: 2, newest: 0, lines: 3, holder: "h" };
const texts = ["start ", "one ", "two "];

function found(generation: number, sequence: number, text: string): FoundLine {
  const key: LineKey = ["s", generation, sequence];
  const line = readLine(key, makeLine(key, bytesOf(text)));
  if (line === null) throw new Error("no line");
  return line;
}

const whole = texts.map((text, at) => found(0, at, text));
const damaged = (line: FoundLine): FoundLine => ({ ...line, isWhole: false });
const readAs = (lines: readonly FoundLine[], from: typeof record | null = record) =>
  assembleGenerations(lines, from).map(({ bytes, isTorn }) => [textOf(bytes), isTorn]);

describe("records of a session", () => {
  it("are believed only where every member is what it should be", () => {
    expect(readSessionRecord(record)).toEqual(record);
    for (const name of Object.keys(record)) {
      for (const value of odd) {
        if (typeof value === (name === "holder" ? "string" : "number") && Object.is(value, 0))
          continue;
        if (name === "holder" && value === "text") continue;
        expect(readSessionRecord({ ...record, [name]: value })).toBeNull();
      }
    }
    for (const value of odd) expect(readSessionRecord(value)).toBeNull();
  });

  it("name a drawing by text only, and show only PNG", () => {
    for (const value of odd) {
      if (value === "text") continue;
      expect(readDescription(value)).toEqual({ name: "", picture: null });
      expect(readDescription({ name: value, picture: value })).toEqual({ name: "", picture: null });
    }
    expect(readDescription({ name: "x".repeat(5000) }).name.length).toBe(1000);
    const html = bytesOf("<html>");
    expect(readDescription({ name: "a", picture: html }).picture).toBeNull();
  });
});

describe("a line", () => {
  it("is whole as it was made", () => {
    expect(readLine(["s", 1, 2], makeLine(["s", 1, 2], bytesOf("a")))?.isWhole).toBe(true);
  });

  it("is damaged by any flipped bit, and in any other place", () => {
    const line = makeLine(["s", 1, 2], bytesOf("some text"));
    for (let bit = 0; bit < 8 * line.bytes.length; ++bit) {
      const bytes = line.bytes.map((byte, at) =>
        at === bit >> 3 ? byte ^ (1 << (bit & 7)) : byte,
      );
      expect(readLine(["s", 1, 2], { ...line, bytes })?.isWhole).toBe(false);
    }
    for (let bit = 0; bit < 32; ++bit) {
      const sum = (line.sum ^ (1 << bit)) >>> 0;
      expect(readLine(["s", 1, 2], { ...line, sum })?.isWhole).toBe(false);
    }
    for (const key of [
      ["t", 1, 2],
      ["s", 0, 2],
      ["s", 1, 3],
      ["s", 12, 2],
    ]) {
      expect(readLine(key, line)?.isWhole).toBe(false);
    }
  });

  it("may be anything at all", () => {
    for (const value of odd) {
      expect(readLine(["s", 0, 0], value)).toMatchObject({ bytes: null, isWhole: false });
      expect(readLine(value, makeLine(["s", 0, 0], bytesOf("a")))).toBeNull();
    }
    for (const key of [
      [],
      ["s"],
      ["s", 0],
      [0, 0, 0],
      ["s", -1, 0],
      ["s", 0, 0.5],
      ["s", 0, 0, 0],
    ]) {
      expect(readLine(key, null)).toBeNull();
    }
  });
});

describe("a generation", () => {
  it("is what its lines say", () => {
    expect(readAs(whole)).toEqual([["start one two ", false]]);
    expect(readAs(whole, null)).toEqual([["start one two ", false]]);
  });

  it("ends before the first line that is damaged or missing, and is torn", () => {
    for (let at = 0; at < 3; ++at) {
      const before = texts.slice(0, at).join("");
      const broken = whole.map((line, place) => (place === at ? damaged(line) : line));
      expect(readAs(broken)).toEqual([[before, true]]);
      expect(readAs(broken, null)).toEqual([[before, true]]);
      expect(readAs(whole.filter((_, place) => place !== at))).toEqual([[before, true]]);
    }
  });

  it("that is lost as a whole is an empty torn one", () => {
    expect(readAs(whole, { ...record, newest: 1 })).toEqual([
      ["start one two ", false],
      ["", true],
    ]);
  });

  it("that is torn stands behind an older one that knows more", () => {
    const copy = [found(1, 0, "start one two "), found(1, 1, "three ")];
    const newest = { ...record, newest: 1, lines: 2 };
    expect(readAs([...whole, ...copy], newest).map(([text]) => text)).toEqual([
      "start one two three ",
      "start one two ",
    ]);
    expect(readAs([...whole, ...copy.map(damaged)], newest)[0]).toEqual(["start one two ", false]);
    const tornEnd = copy.map((line, at) => (at === 1 ? damaged(line) : line));
    expect(readAs([...whole, ...tornEnd], newest)[0]).toEqual(["start one two ", true]);
  });
});

it("raw bytes are all there are, newest generation first", () => {
  const lines = [...whole.map(damaged), found(1, 0, "new")];
  expect(textOf(rawBytes(lines))).toBe("newstart one two ");
  expect(textOf(rawBytes([{ key: ["s", 0, 0], bytes: null, isWhole: false }]))).toBe("");
});
