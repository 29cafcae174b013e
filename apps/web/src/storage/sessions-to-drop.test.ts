// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { sessionsToDrop } from "./sessions-to-drop";

const rows = (count: number) =>
  Array.from({ length: count }, (_, at) => ({
    id: `${at}`,
    name: "",
    changedMs: 1000 - at,
    picture: null,
  }));

describe("sessions that are too many", () => {
  it("are none among twenty", () => {
    expect(sessionsToDrop(rows(20), new Set())).toEqual([]);
  });

  it("are the oldest", () => {
    expect(sessionsToDrop(rows(22), new Set())).toEqual(["20", "21"]);
  });

  it("are never held by a tab", () => {
    expect(sessionsToDrop(rows(22), new Set(["21"]))).toEqual(["19", "20"]);
  });

  it("are never among the last five", () => {
    const held = new Set(
      rows(30)
        .slice(5)
        .map(({ id }) => id),
    );
    expect(sessionsToDrop(rows(30), held)).toEqual([]);
  });
});
