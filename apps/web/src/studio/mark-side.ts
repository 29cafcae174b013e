// SPDX-License-Identifier: Apache-2.0
import type { CoreEvent } from "../protocol/events";

/** What a click of the mark tool says of a place. */
export type MarkSide = "outside" | "inside";

/** For the core a click means outside, and inside with Alt, which a finger has not: a choice stands for it, and Alt for the other one. */
export function markedAs(side: MarkSide, event: CoreEvent): CoreEvent {
  if (event.type !== "pointer" || side === "outside") return event;
  return { ...event, modifiers: { ...event.modifiers, isAlt: !event.modifiers.isAlt } };
}
