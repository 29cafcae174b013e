// SPDX-License-Identifier: Apache-2.0
import type { ResizeInput, ViewEdges } from "../protocol/events";

/**
 * What is fitted into the window stays free of what floats at its edges, px: as shell.css lays it out, with the most rows that the
 * bar below can have. Known before anything is laid out, as a drawing that comes back is fitted before the first picture.
 */
function edgesOf(width: number, height: number): ViewEdges {
  const top = 74;
  // Tools beside a bar of one row.
  if (height < 480 && width >= 560) return { left: 70, top, right: 0, bottom: 66 };
  // Tools, settings and the next step in rows below.
  if (width < 900) return { left: 0, top, right: 0, bottom: 184 };
  // Tools on the left, parts on the right; the next step is above the settings where there is no room beside them.
  return { left: 70, top, right: 272, bottom: width < 1480 ? 128 : top };
}

/** What the core is told of a view of this size, in CSS px. */
export function viewOf(width: number, height: number): ResizeInput {
  return { type: "resize", width, height, edges: edgesOf(width, height) };
}

/** The view before the paper has been laid out: it fills the window. */
export function windowView(): ResizeInput {
  return viewOf(window.innerWidth, window.innerHeight);
}
