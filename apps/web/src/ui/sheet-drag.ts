// SPDX-License-Identifier: Apache-2.0

/** How far a sheet has been slid up. */
export type SheetHeight = "closed" | "short" | "tall";

/** A drag shorter than this is a tap that shook. */
const farEnoughPx = 56;
/** Faster than this is a flick: its way counts, not its length. px per ms */
const flickSpeed = 0.6;

/** Where a sheet comes to rest when its handle is let go. Down is positive. */
export function sheetAfterDrag(from: SheetHeight, movedPx: number, speed: number): SheetHeight {
  const isFar = Math.abs(movedPx) >= farEnoughPx;
  const isFlick = Math.abs(speed) >= flickSpeed;
  if (!isFar && !isFlick) return from;
  const isDown = isFlick ? speed > 0 : movedPx > 0;
  if (!isDown) return "tall";
  return from === "tall" ? "short" : "closed";
}
