// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { outlineLine, type OutlineSink } from "./line-outline";

type Point = readonly [number, number];

/** Writes contours down as polygons. */
class Record implements OutlineSink {
  readonly contours: Point[][] = [];

  moveTo(x: number, y: number): void {
    this.contours.push([[x, y]]);
  }

  lineTo(x: number, y: number): void {
    this.contours.at(-1)?.push([x, y]);
  }

  arc(x: number, y: number, radius: number, from: number, to: number, isBack = false): void {
    const full = 2 * Math.PI;
    const round = (angle: number): number => ((angle % full) + full) % full;
    const whole = Math.abs(to - from) >= full ? full : 0;
    const sweep = whole !== 0 ? whole : isBack ? round(from - to) : round(to - from);
    const steps = Math.ceil(sweep / 0.05);
    for (let i = 0; i <= steps; ++i) {
      const angle = from + ((isBack ? -1 : 1) * sweep * i) / steps;
      this.lineTo(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
    }
  }

  closePath(): void {
    const contour = this.contours.at(-1);
    const first = contour?.[0];
    if (first !== undefined) contour?.push(first);
  }

  /** How often the contours go round a place. */
  winding(x: number, y: number): number {
    let sum = 0;
    for (const contour of this.contours) {
      contour.slice(1).forEach(([x1, y1], i) => {
        const [x0, y0] = contour[i] ?? [x1, y1];
        const side = (x1 - x0) * (y - y0) - (x - x0) * (y1 - y0);
        if (y0 <= y && y1 > y && side > 0) ++sum;
        if (y0 > y && y1 <= y && side < 0) --sum;
      });
    }
    return sum;
  }
}

function outlined(points: number[], widths: number[]): Record {
  const record = new Record();
  outlineLine(record, Float32Array.from(points), Float32Array.from(widths));
  return record;
}

/** Distance from the middle of the line where it is nearest, less the radius that the line has there: below 0 inside. */
function depth(points: number[], widths: number[], x: number, y: number): number {
  let least = Infinity;
  for (let i = 0; 2 * i + 3 < points.length; ++i) {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = points.slice(2 * i, 2 * i + 4);
    const [w0 = 0, w1 = 0] = widths.slice(i, i + 2);
    const along = (x - x0) * (x1 - x0) + (y - y0) * (y1 - y0);
    const t = Math.min(Math.max(along / ((x1 - x0) ** 2 + (y1 - y0) ** 2), 0), 1);
    const distance = Math.hypot(x - x0 - t * (x1 - x0), y - y0 - t * (y1 - y0));
    least = Math.min(least, distance - (w0 + t * (w1 - w0)) / 2);
  }
  return least;
}

/** The outline covers what lies within the line's radius of it, and nothing else. */
function expectToCover(points: number[], widths: number[]): void {
  const record = outlined(points, widths);
  for (let y = -30; y <= 130; y += 3) {
    for (let x = -30; x <= 130; x += 3) {
      const inside = depth(points, widths, x, y);
      if (Math.abs(inside) < 0.3) continue;
      expect([x, y, record.winding(x, y) !== 0]).toEqual([x, y, inside < 0]);
    }
  }
}

describe("the outline of a line", () => {
  it("covers what lies within its radius, whichever way it goes", () => {
    expectToCover([10, 50, 90, 50], [10, 30]);
    expectToCover([90, 50, 10, 50], [10, 30]);
    expectToCover([50, 90, 50, 10], [20, 20]);
  });

  it("has round joins to both sides", () => {
    expectToCover([10, 10, 80, 10, 80, 90], [20, 30, 10]);
    expectToCover([10, 90, 80, 90, 80, 10], [20, 30, 10]);
    expectToCover([0, 50, 90, 50, 5, 45], [24, 24, 24]);
  });

  it("covers a place once where the line crosses itself", () => {
    expectToCover([0, 0, 100, 100, 100, 0, 0, 100], [16, 24, 10, 20]);
  });

  it("turns everywhere the same way, so that nothing cancels out", () => {
    const record = outlined([0, 0, 100, 100, 100, 0, 0, 100, 50, 95], [16, 24, 10, 20, 30]);
    for (let y = -20; y <= 120; y += 3) {
      for (let x = -20; x <= 120; x += 3) expect(record.winding(x, y)).toBeLessThanOrEqual(0);
    }
  });

  it("of one point is a dot, even where the point comes more than once", () => {
    for (const points of [
      [50, 50],
      [50, 50, 50, 50],
    ]) {
      const record = outlined(points, [20, 20]);
      expect(record.winding(50, 59)).not.toBe(0);
      expect(record.winding(50, 61)).toBe(0);
    }
  });

  it("of no point is nothing", () => {
    expect(outlined([], []).contours).toEqual([]);
  });
});
