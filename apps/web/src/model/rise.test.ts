// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { inflation, isOver, moveShare, riseMs, riseTime } from "./rise";

const counts = [1, 2, 5, 13, 200];

describe("a rise", () => {
  it.each(counts)("begins with all of %i parts flat and ends with all as they are", (count) => {
    for (let part = 0; part < count; ++part) {
      expect(inflation(0, part, count)).toBe(0);
      expect(inflation(riseMs(count), part, count)).toBeCloseTo(1, 12);
    }
  });

  it.each(counts)("of %i parts is over within half a second", (count) => {
    expect(riseMs(count)).toBeLessThanOrEqual(500);
  });

  it("lifts no part before the one behind it", () => {
    for (let time = 0; time < 180; time += 10) {
      for (let part = 1; part < 5; ++part) {
        expect(inflation(time, part, 5)).toBeLessThanOrEqual(inflation(time, part - 1, 5));
      }
    }
  });

  it("lets 40 ms pass between few parts", () => {
    expect(inflation(79, 2, 5)).toBe(0);
    expect(inflation(81, 2, 5)).toBeGreaterThan(0);
  });

  it("swells a part a little beyond its height", () => {
    const heights = Array.from({ length: 26 }, (_, i) => inflation(10 * i, 0, 1));
    expect(Math.max(...heights)).toBeGreaterThan(1.02);
    expect(Math.max(...heights)).toBeLessThan(1.1);
  });

  it("moves from the paper to its place in 300 ms, ever slower", () => {
    expect(moveShare(0)).toBe(0);
    expect(moveShare(300)).toBe(1);
    const steps = [0, 100, 200].map((time) => moveShare(time + 100) - moveShare(time));
    expect(steps[0]).toBeGreaterThan(steps[1] ?? 0);
    expect(steps[1]).toBeGreaterThan(steps[2] ?? 0);
  });
});

describe("a fall", () => {
  const fall = { direction: "fall", fromMs: 500, partCount: 5 } as const;

  it("goes back to the paper without turning round", () => {
    let last = 500;
    for (let elapsed = 0; elapsed <= 240; elapsed += 20) {
      const time = riseTime(fall, elapsed);
      expect(time).toBeLessThanOrEqual(last);
      last = time;
    }
    expect(last).toBe(0);
  });

  it("is over after 240 ms, from wherever it began", () => {
    expect(isOver(fall, 239)).toBe(false);
    expect(isOver(fall, 240)).toBe(true);
    expect(isOver({ ...fall, fromMs: 20 }, 240)).toBe(true);
  });

  it("begins where the rise that it breaks off had come to", () => {
    const rise = { direction: "rise", fromMs: 0, partCount: 5 } as const;
    const broken = { ...fall, fromMs: riseTime(rise, 120) };
    expect(riseTime(broken, 0)).toBe(120);
  });
});
