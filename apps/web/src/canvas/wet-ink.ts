// SPDX-License-Identifier: Apache-2.0
import { colourText } from "./colour-text";
import { outlineLine } from "./line-outline";
import { grown, isEmpty, joined, nowhere, roundedOut, type Box } from "./places";
import type { WetTail } from "./wet-lines";

/** As src/render/line_pattern.h, dashed(). */
const dashShare = 3;

/**
 * The canvas over the scene where lines are drawn before the core has them. It is shown in step with the scene: a desynchronized one
 * could be a frame ahead, so that a place is inked twice or not at all, and is not shown where canvases are not accelerated.
 */
export class WetInk {
  readonly canvas = document.createElement("canvas");
  private readonly context: CanvasRenderingContext2D;
  private pixelRatio = 1;
  /** CSS px. */
  private inked: Box = nowhere;

  constructor() {
    const context = this.canvas.getContext("2d");
    if (context === null) throw new Error("this browser has no canvas to draw on");
    this.context = context;
  }

  /** CSS px. */
  resize(width: number, height: number, pixelRatio: number): void {
    this.pixelRatio = pixelRatio;
    this.canvas.width = Math.max(1, Math.round(width * pixelRatio));
    this.canvas.height = Math.max(1, Math.round(height * pixelRatio));
    this.inked = nowhere;
  }

  /** Shows these and nothing else. */
  draw(tails: readonly WetTail[]): void {
    const { context, pixelRatio } = this;
    if (tails.length === 0 && isEmpty(this.inked)) return;
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    const { left, top, right, bottom } = roundedOut(this.inked);
    if (!isEmpty(this.inked)) context.clearRect(left, top, right - left, bottom - top);
    this.inked = nowhere;
    for (const tail of tails) this.drawTail(tail);
  }

  private drawTail({ look, points, beforePx }: WetTail): void {
    const { context } = this;
    const places = Float32Array.from(points.flatMap((point) => [...point.place]));
    const widths = Float32Array.from(points, (point) => point.widthPx);
    const widest = widths.reduce((most, width) => Math.max(most, width), 0);
    for (const { place } of points) {
      const [x, y] = place;
      const at = { left: x, top: y, right: x, bottom: y };
      this.inked = joined(this.inked, grown(at, widest / 2 + 2));
    }
    const path = new Path2D();
    if (look.isDashed && points.length > 1) {
      for (const { place } of points) path.lineTo(place[0], place[1]);
      const dash = dashShare * look.widthPx;
      context.strokeStyle = colourText(look.colour);
      context.lineWidth = widest;
      context.lineCap = "round";
      context.lineJoin = "round";
      context.setLineDash([dash, dash]);
      context.lineDashOffset = beforePx;
      context.stroke(path);
    } else {
      outlineLine(path, places, widths);
      context.fillStyle = colourText(look.colour);
      context.fill(path, "nonzero");
    }
  }
}
