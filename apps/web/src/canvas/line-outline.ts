// SPDX-License-Identifier: Apache-2.0

/** What an outline is written to: a Path2D, or a record of it. */
export type OutlineSink = Pick<Path2D, "moveTo" | "lineTo" | "arc" | "closePath">;

/** A line that turns by less goes round the corner straight: with a radius of 50 px, 0.06 px beside the arc. */
const leastTurnRad = 0.1;

interface Segment {
  readonly x0: number;
  readonly y0: number;
  readonly r0: number;
  readonly x1: number;
  readonly y1: number;
  readonly r1: number;
  /** Of the normal to the right of the way, with y down. */
  readonly angle: number;
}

function segmentsOf(points: Float32Array, widths: Float32Array): Segment[] {
  const segments: Segment[] = [];
  const radius = (i: number): number => (widths[Math.min(i, widths.length - 1)] ?? 0) / 2;
  let from = 0;
  for (let i = 1; 2 * i + 1 < points.length; ++i) {
    const x0 = points[2 * from] ?? 0;
    const y0 = points[2 * from + 1] ?? 0;
    const x1 = points[2 * i] ?? 0;
    const y1 = points[2 * i + 1] ?? 0;
    if (x0 === x1 && y0 === y1) continue;
    const angle = Math.atan2(y1 - y0, x1 - x0) + Math.PI / 2;
    segments.push({ x0, y0, r0: radius(from), x1, y1, r1: radius(i), angle });
    from = i;
  }
  return segments;
}

/** From -pi to pi. */
function turn(from: number, to: number): number {
  const difference = to - from;
  return difference - 2 * Math.PI * Math.round(difference / (2 * Math.PI));
}

function edge(sink: OutlineSink, x: number, y: number, radius: number, angle: number): void {
  sink.lineTo(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
}

/**
 * Goes round a joint on one side. The outer side is an arc, or straight where the turn is slight; the inner one goes through the
 * point itself, so that the outline stays the sum of quads and sectors that all turn the same way.
 */
function join(sink: OutlineSink, x: number, y: number, r: number, from: number, to: number): void {
  const angle = turn(from, to);
  if (Math.abs(angle) < leastTurnRad) {
    edge(sink, x, y, r, to);
  } else if (angle < 0) {
    sink.arc(x, y, r, from, to, true);
  } else {
    sink.lineTo(x, y);
    edge(sink, x, y, r, to);
  }
}

function dot(sink: OutlineSink, x: number, y: number, radius: number): void {
  sink.moveTo(x + radius, y);
  sink.arc(x, y, radius, 0, 2 * Math.PI, true);
  sink.closePath();
}

/**
 * The outline of a line whose width changes from point to point, with round caps and joins: what src/render/stroke_coverage.cpp covers.
 * One closed contour; filled nonzero it covers each place once, however often the line crosses itself.
 *
 * points: x, y, x, y, ...; widths: one, or one for each point.
 */
export function outlineLine(sink: OutlineSink, points: Float32Array, widths: Float32Array): void {
  const segments = segmentsOf(points, widths);
  const first = segments[0];
  const last = segments.at(-1);
  if (first === undefined || last === undefined) {
    if (points.length >= 2) dot(sink, points[0] ?? 0, points[1] ?? 0, Math.max(...widths) / 2);
    return;
  }
  const { x0, y0, r0, angle } = first;
  sink.moveTo(x0 + r0 * Math.cos(angle), y0 + r0 * Math.sin(angle));
  let before = first;
  for (const each of segments) {
    if (each !== before) join(sink, each.x0, each.y0, each.r0, before.angle, each.angle);
    edge(sink, each.x1, each.y1, each.r1, each.angle);
    before = each;
  }
  sink.arc(last.x1, last.y1, last.r1, last.angle, last.angle - Math.PI, true);
  for (let i = segments.length - 1; i >= 0; --i) {
    const each = segments[i] ?? last;
    const next = segments[i + 1];
    if (next !== undefined) {
      join(sink, each.x1, each.y1, each.r1, next.angle - Math.PI, each.angle - Math.PI);
    }
    edge(sink, each.x0, each.y0, each.r0, each.angle - Math.PI);
  }
  sink.arc(x0, y0, r0, angle - Math.PI, angle - 2 * Math.PI, true);
  sink.closePath();
}
