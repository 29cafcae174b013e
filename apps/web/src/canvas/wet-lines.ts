// SPDX-License-Identifier: Apache-2.0
import type { Rgba } from "../protocol/scene";
import type { ScreenPoint } from "./places";

/** How a line will look. */
export interface WetLook {
  readonly colour: Rgba;
  /** px of the screen at full pressure. */
  readonly widthPx: number;
  readonly isDashed: boolean;
}

export interface WetPoint {
  readonly place: ScreenPoint;
  /** px of the screen. */
  readonly widthPx: number;
}

/** What of a line the core has not drawn yet. */
export interface WetTail {
  readonly look: WetLook;
  readonly points: readonly WetPoint[];
  /** Length of the line before the tail, px of the screen: dashes go on from there. */
  readonly beforePx: number;
}

interface SentPoint extends WetPoint {
  readonly sequence: number;
  readonly alongPx: number;
}

interface WetLine {
  readonly pointer: number;
  readonly look: WetLook;
  /** From the last one on that the core has drawn. */
  points: SentPoint[];
  /** Where the pointer may be next. */
  predicted: readonly WetPoint[];
  isEnded: boolean;
}

/**
 * Keeps account of lines between the pen and the core: points come with the number of the event that carries them, and go when a
 * frame has taken that event in, but for the last, from which the rest goes on.
 */
export class WetLines {
  private lines: WetLine[] = [];
  private taken = 0;

  /** Lines of the same pointer that go on are ended: there is one of each. */
  begin(pointer: number, look: WetLook, point: WetPoint, sequence: number): void {
    this.end(pointer);
    const points = [{ ...point, sequence, alongPx: 0 }];
    this.lines.push({ pointer, look, points, predicted: [], isEnded: false });
  }

  add(pointer: number, point: WetPoint, sequence: number): void {
    const line = this.going(pointer);
    const last = line?.points.at(-1);
    if (line === undefined || last === undefined) return;
    const step = Math.hypot(point.place[0] - last.place[0], point.place[1] - last.place[1]);
    line.points.push({ ...point, sequence, alongPx: last.alongPx + step });
    line.predicted = [];
  }

  predict(pointer: number, points: readonly WetPoint[]): void {
    const line = this.going(pointer);
    if (line !== undefined) line.predicted = points;
  }

  /** The line is complete; it stays until the core has drawn it. */
  end(pointer: number): void {
    const line = this.going(pointer);
    if (line === undefined) return;
    line.isEnded = true;
    line.predicted = [];
  }

  endAll(): void {
    for (const line of this.lines) this.end(line.pointer);
  }

  /** The line never was. */
  drop(pointer: number): void {
    this.lines = this.lines.filter((line) => line.isEnded || line.pointer !== pointer);
  }

  /** All that go on. */
  dropAll(): void {
    this.lines = this.lines.filter((line) => line.isEnded);
  }

  get isAnyGoing(): boolean {
    return this.lines.some((line) => !line.isEnded);
  }

  look(pointer: number): WetLook | null {
    return this.going(pointer)?.look ?? null;
  }

  /** Where the line is now. */
  lastWidthPx(pointer: number): number | null {
    return this.going(pointer)?.points.at(-1)?.widthPx ?? null;
  }

  /** The core has drawn all that came with events up to a number. */
  takeIn(sequence: number): void {
    for (const line of this.lines) {
      const drawn = line.points.findLastIndex((point) => point.sequence <= sequence);
      if (drawn > 0) line.points = line.points.slice(drawn);
    }
    this.lines = this.lines.filter((line) => {
      const last = line.points.at(-1);
      return !line.isEnded || (last !== undefined && last.sequence > sequence);
    });
    this.taken = sequence;
  }

  tails(): readonly WetTail[] {
    return this.lines.flatMap((line) => {
      const [first, ...rest] = line.points;
      if (first === undefined) return [];
      const isDrawn = rest.length === 0 && first.sequence <= this.taken;
      if (isDrawn && line.predicted.length === 0) return [];
      const points = [first, ...rest, ...line.predicted];
      return [{ look: line.look, points, beforePx: first.alongPx }];
    });
  }

  private going(pointer: number): WetLine | undefined {
    return this.lines.find((line) => !line.isEnded && line.pointer === pointer);
  }
}
