// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "./actions.generated";

/** What the page hands to the core: src/editor/events.h, in the same words. */

export interface Modifiers {
  readonly isShift: boolean;
  /** Cmd where that is the custom. */
  readonly isCtrl: boolean;
  readonly isAlt: boolean;
}

export const pointerActions = ["press", "move", "release", "cancel"] as const;
export type PointerAction = (typeof pointerActions)[number];

export const pointerKinds = ["mouse", "pen", "touch"] as const;
export type PointerKind = (typeof pointerKinds)[number];

export const pointerButtons = ["none", "primary", "middle", "secondary", "eraser"] as const;
export type PointerButton = (typeof pointerButtons)[number];

export const fileUses = ["open", "add", "template"] as const;
export type FileUse = (typeof fileUses)[number];

export interface PointerInput {
  readonly type: "pointer";
  readonly action: PointerAction;
  readonly kind: PointerKind;
  readonly id: number;
  /** That was pressed or released. */
  readonly button: PointerButton;
  /** px of the view, origin top left. */
  readonly x: number;
  readonly y: number;
  /** 0 .. 1; 0.5 where there is none to measure. */
  readonly pressure: number;
  readonly timeS: number;
  readonly modifiers: Modifiers;
}

export interface KeyInput {
  readonly type: "key";
  /** As KeyboardEvent.key names it. */
  readonly key: string;
  readonly isPress: boolean;
  readonly isRepeat: boolean;
  readonly timeS: number;
  readonly modifiers: Modifiers;
}

export interface WheelInput {
  readonly type: "wheel";
  readonly x: number;
  readonly y: number;
  /** px; positive: content moves up and left. */
  readonly deltaX: number;
  readonly deltaY: number;
  readonly modifiers: Modifiers;
}

/** A pinch that the system has recognised (WebKit's gesture events). */
export interface GestureInput {
  readonly type: "gesture";
  readonly x: number;
  readonly y: number;
  /** Since the event before. */
  readonly scale: number;
  readonly movedX: number;
  readonly movedY: number;
}

export interface ActionInput {
  readonly type: "action";
  readonly name: ActionName;
  /** For actions that take one: a name, a number, a colour, a place "x,y". */
  readonly argument: string;
}

export interface FileInput {
  readonly type: "file";
  readonly bytes: Uint8Array;
  readonly name: string;
  readonly use: FileUse;
}

/** How far bars and panels reach into the view, CSS px. */
export interface ViewEdges {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

export const noEdges: ViewEdges = { left: 0, top: 0, right: 0, bottom: 0 };

export interface ResizeInput {
  readonly type: "resize";
  /** CSS px. */
  readonly width: number;
  readonly height: number;
  readonly edges: ViewEdges;
}

export type CoreEvent =
  PointerInput | KeyInput | WheelInput | GestureInput | ActionInput | FileInput | ResizeInput;
