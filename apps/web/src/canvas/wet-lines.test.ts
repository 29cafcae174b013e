// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { WetLines, type WetLook, type WetPoint } from "./wet-lines";

const look: WetLook = { colour: 0xff000000, widthPx: 3, isDashed: false };
const at = (x: number): WetPoint => ({ place: [x, 0], widthPx: 3 });

/** A line of the pointer 1: a point at each multiple of 10, with the events 1, 2, ... */
function drawn(count: number): WetLines {
  const lines = new WetLines();
  lines.begin(1, look, at(0), 1);
  for (let i = 1; i < count; ++i) lines.add(1, at(10 * i), i + 1);
  return lines;
}

const places = (lines: WetLines): number[][] =>
  lines.tails().map((tail) => tail.points.map((point) => point.place[0]));

describe("wet ink", () => {
  it("shows a line from its first point on before the core has it", () => {
    expect(places(drawn(3))).toEqual([[0, 10, 20]]);
  });

  it("begins where the core's line ends, and knows how far along that is", () => {
    const lines = drawn(4);
    lines.takeIn(2);
    expect(places(lines)).toEqual([[10, 20, 30]]);
    expect(lines.tails()[0]?.beforePx).toBe(10);
  });

  it("shows nothing once the core has all of it", () => {
    const lines = drawn(3);
    lines.takeIn(3);
    expect(places(lines)).toEqual([]);
  });

  it("goes on after a time when the core had all of it", () => {
    const lines = drawn(3);
    lines.takeIn(3);
    lines.add(1, at(40), 4);
    expect(places(lines)).toEqual([[20, 40]]);
  });

  it("stays after the release until a frame has taken that in", () => {
    const lines = drawn(3);
    lines.end(1);
    lines.takeIn(2);
    expect(places(lines)).toEqual([[10, 20]]);
    lines.takeIn(3);
    expect(places(lines)).toEqual([]);
  });

  it("keeps lines apart that follow each other before a frame comes", () => {
    const lines = drawn(2);
    lines.end(1);
    lines.begin(1, look, at(50), 3);
    lines.add(1, at(60), 4);
    expect(places(lines)).toEqual([
      [0, 10],
      [50, 60],
    ]);
    lines.takeIn(3);
    expect(places(lines)).toEqual([[50, 60]]);
  });

  it("takes back what was predicted when the next point comes", () => {
    const lines = drawn(2);
    lines.predict(1, [at(18), at(25)]);
    expect(places(lines)).toEqual([[0, 10, 18, 25]]);
    lines.add(1, at(20), 3);
    expect(places(lines)).toEqual([[0, 10, 20]]);
  });

  it("that is dropped is gone, but not what was complete", () => {
    const lines = drawn(2);
    lines.end(1);
    lines.begin(2, look, at(50), 3);
    lines.dropAll();
    expect(places(lines)).toEqual([[0, 10]]);
  });
});
