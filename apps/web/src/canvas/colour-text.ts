// SPDX-License-Identifier: Apache-2.0
import type { Rgba } from "../protocol/scene";

/** A colour as CSS takes it. */
export function colourText(colour: Rgba): string {
  const byte = (shift: number): string => ((colour >>> shift) & 0xff).toString(16).padStart(2, "0");
  return `#${byte(0)}${byte(8)}${byte(16)}${byte(24)}`;
}
