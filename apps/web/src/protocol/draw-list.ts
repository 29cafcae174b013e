// SPDX-License-Identifier: Apache-2.0
import type { AffineNumbers, Rgba } from "./scene";

/** Draw lists as the core writes them: src/render/draw_list.h; layout in docs/WEB_STUDIO.md. */

export interface FilledPath {
  readonly kind: "fill";
  readonly colour: Rgba;
  /** x, y, x, y, ... The area is where they wind around at all (non-zero). */
  readonly contours: readonly Float32Array[];
}

export interface StrokedPolyline {
  readonly kind: "stroke";
  readonly colour: Rgba;
  readonly points: Float32Array;
  /** One for the whole line, or one for each point. */
  readonly widths: Float32Array;
  /** On, off, on, ...; empty: solid. On 0: dots. */
  readonly dashes: Float32Array;
  /** px of the screen; the most may be infinite. */
  readonly leastPx: number;
  readonly mostPx: number;
}

export interface Dots {
  readonly kind: "dots";
  readonly colour: Rgba;
  readonly centres: Float32Array;
  readonly diameter: number;
}

export interface DrawnPicture {
  readonly kind: "picture";
  /** 0 .. 1 */
  readonly opacity: number;
  readonly map: AffineNumbers;
  readonly width: number;
  readonly height: number;
  /** RGBA */
  readonly pixels: Uint8ClampedArray;
}

export type DrawItem = FilledPath | StrokedPolyline | Dots | DrawnPicture;

/** Items begin with their kind. All numbers are of 4 bytes, little end first. */
export const drawItemCodes = { fill: 0, stroke: 1, dots: 2, picture: 3 } as const;

/** Reads numbers one after another. */
class Words {
  private at = 0;
  private readonly view: DataView;

  constructor(private readonly bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  get isAtEnd(): boolean {
    return this.at >= this.bytes.byteLength;
  }

  whole(): number {
    const value = this.view.getUint32(this.at, true);
    this.at += 4;
    return value;
  }

  real(): number {
    const value = this.view.getFloat32(this.at, true);
    this.at += 4;
    return value;
  }

  /** A copy, so that it may lie anywhere. */
  reals(count: number): Float32Array {
    const start = this.bytes.byteOffset + this.at;
    this.at += 4 * count;
    return new Float32Array(this.bytes.buffer.slice(start, start + 4 * count));
  }

  pixels(count: number): Uint8ClampedArray {
    const start = this.bytes.byteOffset + this.at;
    this.at += 4 * count;
    return new Uint8ClampedArray(this.bytes.buffer.slice(start, start + 4 * count));
  }
}

function readFill(words: Words): FilledPath {
  const colour = words.whole();
  const contours: Float32Array[] = [];
  for (let left = words.whole(); left > 0; --left) contours.push(words.reals(2 * words.whole()));
  return { kind: "fill", colour, contours };
}

function readStroke(words: Words): StrokedPolyline {
  const colour = words.whole();
  const pointCount = words.whole();
  const widthCount = words.whole();
  const dashCount = words.whole();
  const leastPx = words.real();
  const mostPx = words.real();
  const points = words.reals(2 * pointCount);
  const widths = words.reals(widthCount);
  const dashes = words.reals(dashCount);
  return { kind: "stroke", colour, points, widths, dashes, leastPx, mostPx };
}

function readDots(words: Words): Dots {
  const colour = words.whole();
  const count = words.whole();
  const diameter = words.real();
  return { kind: "dots", colour, diameter, centres: words.reals(2 * count) };
}

function readPicture(words: Words): DrawnPicture {
  const opacity = words.real();
  const width = words.whole();
  const height = words.whole();
  const map = [
    words.real(),
    words.real(),
    words.real(),
    words.real(),
    words.real(),
    words.real(),
  ] as const;
  return { kind: "picture", opacity, width, height, map, pixels: words.pixels(width * height) };
}

function readItem(words: Words): DrawItem {
  const code = words.whole();
  switch (code) {
    case drawItemCodes.fill:
      return readFill(words);
    case drawItemCodes.stroke:
      return readStroke(words);
    case drawItemCodes.dots:
      return readDots(words);
    case drawItemCodes.picture:
      return readPicture(words);
    default:
      throw new Error(`draw list: no item has the code ${code}`);
  }
}

/** Reads a list that the core has written; throws on any other. */
export function readDrawList(bytes: Uint8Array): DrawItem[] {
  const words = new Words(bytes);
  const items: DrawItem[] = [];
  while (!words.isAtEnd) items.push(readItem(words));
  return items;
}
