// SPDX-License-Identifier: Apache-2.0
import type { Dots, DrawItem, DrawnPicture, FilledPath } from "../protocol/draw-list";
import { colourText } from "./colour-text";
import { PaintedLine } from "./painted-line";
import { boxOf, grown, joined, mapped, nowhere, type Box } from "./places";

/** What can be drawn on: of a canvas on the page or off it. */
export type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

/** One item of a draw list with what was made of it for a canvas. */
export interface PaintedItem {
  /** px of the list, at a scale: CSS px of the screen for one of the list. */
  box(scale: number): Box;
  /** About how many points have to be drawn. */
  readonly cost: number;
  /** The context's map takes px of the list. */
  paint(context: Context, scale: number): void;
}

function paintedFill(fill: FilledPath): PaintedItem {
  const path = new Path2D();
  let box = nowhere;
  let cost = 1;
  for (const contour of fill.contours) {
    path.moveTo(contour[0] ?? 0, contour[1] ?? 0);
    for (let i = 2; i + 1 < contour.length; i += 2) {
      path.lineTo(contour[i] ?? 0, contour[i + 1] ?? 0);
    }
    path.closePath();
    box = joined(box, boxOf(contour));
    cost += contour.length / 2;
  }
  const colour = colourText(fill.colour);
  return {
    box: () => box,
    cost,
    paint(context) {
      context.fillStyle = colour;
      context.fill(path, "nonzero");
    },
  };
}

function paintedDots(dots: Dots): PaintedItem {
  const path = new Path2D();
  const radius = dots.diameter / 2;
  for (let i = 0; i + 1 < dots.centres.length; i += 2) {
    const x = dots.centres[i] ?? 0;
    const y = dots.centres[i + 1] ?? 0;
    path.moveTo(x + radius, y);
    path.arc(x, y, radius, 0, 2 * Math.PI);
  }
  const box = grown(boxOf(dots.centres), radius);
  const colour = colourText(dots.colour);
  return {
    box: () => box,
    cost: 1 + dots.centres.length,
    paint(context) {
      context.fillStyle = colour;
      context.fill(path, "nonzero");
    },
  };
}

/** A picture costs what it covers: as much as a long line. */
const pictureCost = 500;

function paintedPicture(drawn: DrawnPicture): PaintedItem {
  const { width, height, map, opacity } = drawn;
  const picture = new OffscreenCanvas(Math.max(width, 1), Math.max(height, 1));
  if (width > 0 && height > 0) {
    const data = new ImageData(new Uint8ClampedArray(drawn.pixels), width, height);
    picture.getContext("2d")?.putImageData(data, 0, 0);
  }
  const box = mapped({ left: 0, top: 0, right: width, bottom: height }, map);
  return {
    box: () => box,
    cost: pictureCost,
    paint(context) {
      context.save();
      context.transform(...map);
      context.globalAlpha = opacity;
      context.imageSmoothingQuality = "medium";
      context.drawImage(picture, 0, 0);
      context.restore();
    },
  };
}

export function paintedItem(item: DrawItem): PaintedItem {
  switch (item.kind) {
    case "fill":
      return paintedFill(item);
    case "stroke":
      return new PaintedLine(item);
    case "dots":
      return paintedDots(item);
    case "picture":
      return paintedPicture(item);
  }
}
