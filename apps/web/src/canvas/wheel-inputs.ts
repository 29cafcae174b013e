// SPDX-License-Identifier: Apache-2.0
import type { GestureInput, WheelInput } from "../protocol/events";
import { modifiersOf, type Corner } from "./pointer-inputs";

export type WheelLike = Pick<
  WheelEvent,
  | "deltaX"
  | "deltaY"
  | "deltaMode"
  | "clientX"
  | "clientY"
  | "shiftKey"
  | "ctrlKey"
  | "metaKey"
  | "altKey"
>;

/** A notch of a mouse is three lines, and 100 px where browsers count in px. */
const pxPerLine = 100 / 3;
/** WheelEvent.deltaMode */
const inLines = 1;
const inPages = 2;

/** height: of the view, CSS px. */
export function wheelInput(
  event: WheelLike,
  corner: Corner,
  height: number,
  isApple: boolean,
): WheelInput {
  const px = { [inLines]: pxPerLine, [inPages]: height }[event.deltaMode] ?? 1;
  const modifiers = modifiersOf(event, isApple);
  return {
    type: "wheel",
    x: event.clientX - corner.left,
    y: event.clientY - corner.top,
    deltaX: event.deltaX * px,
    deltaY: event.deltaY * px,
    // A trackpad's pinch comes as a wheel with Ctrl on every system.
    modifiers: { ...modifiers, isCtrl: modifiers.isCtrl || event.ctrlKey },
  };
}

/** What WebKit alone sends: scale is since the beginning. */
export interface WebKitGesture extends UIEvent {
  readonly scale: number;
  readonly clientX: number;
  readonly clientY: number;
}

type GestureLike = Pick<WebKitGesture, "scale" | "clientX" | "clientY">;

/** Turns WebKit's gestures into steps from event to event. */
export class GestureInputs {
  private last: GestureLike = { scale: 1, clientX: 0, clientY: 0 };

  start(event: GestureLike): void {
    this.last = event;
  }

  change(event: GestureLike, corner: Corner): GestureInput {
    const { last } = this;
    this.last = { scale: event.scale, clientX: event.clientX, clientY: event.clientY };
    return {
      type: "gesture",
      x: event.clientX - corner.left,
      y: event.clientY - corner.top,
      scale: last.scale > 0 ? event.scale / last.scale : 1,
      movedX: event.clientX - last.clientX,
      movedY: event.clientY - last.clientY,
    };
  }
}
