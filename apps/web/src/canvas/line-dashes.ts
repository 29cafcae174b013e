// SPDX-License-Identifier: Apache-2.0

export interface LinePiece {
  /** x, y, x, y, ... */
  readonly points: Float32Array;
  /** One for each point. */
  readonly widths: Float32Array;
}

/** No line gets more dashes: as src/render/dash.cpp has it. */
const mostDashes = 100_000;

/** Walks along a line and cuts it where the pattern changes. */
class Dasher {
  readonly pieces: LinePiece[] = [];
  private points: number[] = [];
  private widths: number[] = [];
  private isOn = true;
  private index = 0;
  private left: number;

  constructor(private readonly dashes: Float32Array) {
    this.left = dashes[0] ?? Infinity;
  }

  add(x: number, y: number, width: number): void {
    this.points.push(x, y);
    this.widths.push(width);
  }

  end(): void {
    if (this.isOn && this.widths.length > 0) {
      this.pieces.push({
        points: Float32Array.from(this.points),
        widths: Float32Array.from(this.widths),
      });
    }
    this.points = [];
    this.widths = [];
  }

  walk(from: readonly number[], to: readonly number[]): void {
    const [x0 = 0, y0 = 0, w0 = 0] = from;
    const [x1 = 0, y1 = 0, w1 = 0] = to;
    const length = Math.hypot(x1 - x0, y1 - y0);
    let done = 0;
    while (length - done > this.left && this.pieces.length < mostDashes) {
      done += this.left;
      const t = done / length;
      this.turn(x0 + t * (x1 - x0), y0 + t * (y1 - y0), w0 + t * (w1 - w0));
    }
    this.left -= length - done;
    if (this.isOn && length > 0) this.add(x1, y1, w1);
  }

  private turn(x: number, y: number, width: number): void {
    this.add(x, y, width);
    if (this.isOn) this.end();
    this.isOn = !this.isOn;
    this.index = (this.index + 1) % this.dashes.length;
    this.left = this.dashes[this.index] ?? Infinity;
  }
}

/** The drawn pieces of a dashed line whose width changes; a canvas dashes only lines of one width. */
export function dashedPieces(
  points: Float32Array,
  widths: Float32Array,
  dashes: Float32Array,
): readonly LinePiece[] {
  const at = (i: number): readonly number[] => [
    points[2 * i] ?? 0,
    points[2 * i + 1] ?? 0,
    widths[Math.min(i, widths.length - 1)] ?? 0,
  ];
  const dasher = new Dasher(dashes);
  const [x = 0, y = 0, width = 0] = at(0);
  dasher.add(x, y, width);
  for (let i = 1; 2 * i + 1 < points.length; ++i) dasher.walk(at(i - 1), at(i));
  dasher.end();
  return dasher.pieces;
}
