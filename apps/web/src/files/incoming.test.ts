// SPDX-License-Identifier: Apache-2.0
import { beforeEach, describe, expect, it } from "vitest";
import { FakeStudio } from "./studio-in-test";
import { mostFileBytes } from "./file-types";
import { Incoming } from "./incoming";

const refusal = { severity: "problem", text: "no", place: null } as const;
let fake: FakeStudio;
let incoming: Incoming;

beforeEach(() => {
  fake = new FakeStudio();
  incoming = new Incoming(fake.studio);
});

function sized(name: string, bytes: number): File {
  return Object.defineProperty(new File([], name), "size", { value: bytes });
}

describe("files that nobody asked for", () => {
  it("are refused before they are read when they are too large", () => {
    incoming.take([sized("film.png", mostFileBytes + 1)]);
    expect(fake.calls).toEqual([]);
    expect(fake.told[0]?.text).toBe("file_too_large film.png 65 64");
  });

  it("are taken up to the limit", () => {
    incoming.take([sized("a.svg", mostFileBytes)]);
    expect(fake.calls).toEqual(["open a.svg"]);
  });

  it("come all when there are several: the first finds its place, the others come to it", () => {
    incoming.take([new File([], "a.svg"), new File([], "b.svg")]);
    expect(fake.calls).toEqual(["open a.svg", "add b.svg"]);
  });
});

describe("the offer to use a file in another way", () => {
  beforeEach(() => {
    fake.frame({ isBlank: false, undo: "brush" });
    incoming.take([new File([], "a.svg")]);
  });

  it("comes when the core has taken the file", () => {
    expect(fake.told).toEqual([]);
    fake.frame({ undo: "open" });
    expect(fake.told.map(({ text }) => text)).toEqual(["file_is_added a.svg"]);
  });

  it("comes once", () => {
    fake.frame({ undo: "open" });
    fake.frame({ undo: "open" });
    expect(fake.told.length).toBe(1);
  });

  it("does not come when the core refuses the file", () => {
    fake.frame({}, [refusal]);
    fake.frame({ undo: "open" });
    expect(fake.told).toEqual([]);
  });

  it("takes back what was done first", () => {
    fake.frame({ undo: "open" });
    fake.told[0]?.remedy?.run();
    expect(fake.calls).toEqual(["add a.svg", "undo", "open a.svg"]);
  });

  it("takes back nothing that was done since", () => {
    fake.frame({ undo: "open" });
    fake.frame({ undo: "brush" });
    fake.told[0]?.remedy?.run();
    expect(fake.calls).toEqual(["add a.svg", "open a.svg"]);
  });
});
