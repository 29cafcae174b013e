// SPDX-License-Identifier: Apache-2.0
import type { StrokedPolyline } from "../protocol/draw-list";
import { colourText } from "./colour-text";
import { dashedPieces } from "./line-dashes";
import { outlineLine } from "./line-outline";
import { isWithinLimits, widthsAt, type LineWidths } from "./line-widths";
import type { Context, PaintedItem } from "./painted-item";
import { boxOf, grown, type Box } from "./places";

/** A path made for one scale serves at others up to this ratio, though limits make the line wider or thinner there: less than shows. */
const sameScaleRatio = 1.02;

/** What was made of a line for a scale. */
interface LinePath {
  readonly scale: number;
  /** Made of widths that no limit has changed: serves wherever none does. */
  readonly isUnlimited: boolean;
  readonly path: Path2D;
  /** null: the path is an outline, to be filled. */
  readonly stroke: { readonly width: number; readonly dashes: readonly number[] } | null;
}

function centreLine(points: Float32Array): Path2D {
  const path = new Path2D();
  for (let i = 0; i + 1 < points.length; i += 2) path.lineTo(points[i] ?? 0, points[i + 1] ?? 0);
  return path;
}

function outline(points: Float32Array, { widths, dashes }: LineWidths): Path2D {
  const path = new Path2D();
  if (dashes.length === 0) {
    outlineLine(path, points, widths);
  } else {
    for (const piece of dashedPieces(points, widths, dashes)) {
      outlineLine(path, piece.points, piece.widths);
    }
  }
  return path;
}

/** A stroked polyline; lines of one width are left to the canvas, others become an outline. */
export class PaintedLine implements PaintedItem {
  readonly cost: number;
  private readonly colour: string;
  private readonly centres: Box;
  private readonly widest: number;
  private made: LinePath | null = null;

  constructor(private readonly line: StrokedPolyline) {
    this.cost = 1 + line.points.length / 2;
    this.colour = colourText(line.colour);
    this.centres = boxOf(line.points);
    this.widest = line.widths.reduce((most, width) => Math.max(most, width), 0);
  }

  box(scale: number): Box {
    return grown(this.centres, Math.max(this.widest, this.line.leastPx / scale) / 2);
  }

  paint(context: Context, scale: number): void {
    const { path, stroke } = this.pathAt(scale);
    if (stroke === null) {
      context.fillStyle = this.colour;
      context.fill(path, "nonzero");
      return;
    }
    context.strokeStyle = this.colour;
    context.lineWidth = stroke.width;
    if (stroke.dashes.length > 0) context.setLineDash([...stroke.dashes]);
    context.stroke(path);
    if (stroke.dashes.length > 0) context.setLineDash([]);
  }

  private pathAt(scale: number): LinePath {
    const isUnlimited = isWithinLimits(this.line, scale);
    const { made } = this;
    if (made !== null && isUnlimited && made.isUnlimited) return made;
    if (made !== null && isUnlimited === made.isUnlimited && isNear(made.scale, scale)) return made;
    this.made = this.make(scale, isUnlimited);
    return this.made;
  }

  private make(scale: number, isUnlimited: boolean): LinePath {
    const at = widthsAt(this.line, scale);
    const { points } = this.line;
    // A canvas leaves out what goes nowhere, caps and all.
    const { left, top, right, bottom } = this.centres;
    const isDot = left === right && top === bottom;
    if (at.widths.length > 1 || isDot) {
      return { scale, isUnlimited, path: outline(points, at), stroke: null };
    }
    const stroke = { width: at.widths[0] ?? 0, dashes: [...at.dashes] };
    return { scale, isUnlimited, path: centreLine(points), stroke };
  }
}

function isNear(a: number, b: number): boolean {
  return Math.max(a, b) <= sameScaleRatio * Math.min(a, b);
}
