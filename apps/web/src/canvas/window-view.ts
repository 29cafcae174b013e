// SPDX-License-Identifier: Apache-2.0
import type { ResizeInput } from "../protocol/events";

/** What is fitted into the window leaves the bars above and below it free, px. */
const barsPx = 148;

/** What the core is told of a view of this size, in CSS px. */
export function viewOf(width: number, height: number): ResizeInput {
  return { type: "resize", width, height, bars: barsPx };
}

/** The view before the paper has been laid out: it fills the window. */
export function windowView(): ResizeInput {
  return viewOf(window.innerWidth, window.innerHeight);
}
