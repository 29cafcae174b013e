// SPDX-License-Identifier: Apache-2.0
import type { Modifiers, PointerButton, PointerInput, PointerKind } from "../protocol/events";

/** What is read of a PointerEvent. */
export type PointerLike = Pick<
  PointerEvent,
  | "pointerId"
  | "pointerType"
  | "button"
  | "buttons"
  | "clientX"
  | "clientY"
  | "pressure"
  | "timeStamp"
  | "shiftKey"
  | "ctrlKey"
  | "metaKey"
  | "altKey"
>;

/** Where the view begins in the window, CSS px. */
export interface Corner {
  readonly left: number;
  readonly top: number;
}

const buttonNames: readonly PointerButton[] = ["primary", "middle", "secondary"];
/** Of PointerEvent.button and .buttons: the other end of a pen. */
const eraserButton = 5;
const eraserBit = 32;

export function modifiersOf(
  event: Pick<PointerLike, "shiftKey" | "ctrlKey" | "metaKey" | "altKey">,
  isApple: boolean,
): Modifiers {
  return {
    isShift: event.shiftKey,
    isCtrl: isApple ? event.metaKey : event.ctrlKey,
    isAlt: event.altKey,
  };
}

function kindOf(event: PointerLike): PointerKind {
  return event.pointerType === "pen" || event.pointerType === "touch" ? event.pointerType : "mouse";
}

/** Turns pointer events of the page into those of the core; knows what is down. */
export class PointerInputs {
  /** The last that the core was told of each pointer that is down. */
  private readonly down = new Map<number, PointerInput>();

  constructor(private readonly isApple: boolean) {}

  press(event: PointerLike, corner: Corner): PointerInput {
    return this.keep(this.input(event, corner, "press", this.buttonOf(event)));
  }

  /** A button may go down or up while another one holds the mouse: that comes as a move. */
  move(event: PointerLike, corner: Corner): PointerInput {
    const isChord = event.button >= 0 && kindOf(event) === "mouse";
    if (!isChord) return this.keepIfDown(this.input(event, corner, "move", "none"));
    // Bits of the middle and the right button change places.
    const bit = [1, 4, 2][event.button] ?? 0;
    const isPress = (event.buttons & bit) !== 0;
    if (isPress) return this.press(event, corner);
    return this.keepIfDown(this.input(event, corner, "release", this.buttonOf(event)));
  }

  /** Where the pointer may be, of which the core is not told. */
  guess(event: PointerLike, corner: Corner): PointerInput {
    return this.input(event, corner, "move", "none");
  }

  /** null: it was not down. */
  release(event: PointerLike, corner: Corner): PointerInput | null {
    const pressed = this.down.get(event.pointerId);
    if (pressed === undefined) return null;
    this.down.delete(event.pointerId);
    const isMouse = pressed.kind === "mouse";
    const button = isMouse ? this.releasedButton(event, pressed) : pressed.button;
    return this.input(event, corner, "release", button);
  }

  /** null: it was not down. */
  cancel(id: number, timeS: number): PointerInput | null {
    const last = this.down.get(id);
    this.down.delete(id);
    return last === undefined ? null : { ...last, action: "cancel", timeS };
  }

  cancelAll(timeS: number): readonly PointerInput[] {
    return [...this.down.keys()].flatMap((id) => this.cancel(id, timeS) ?? []);
  }

  isDown(id: number): boolean {
    return this.down.has(id);
  }

  get hasFingers(): boolean {
    return [...this.down.values()].some((input) => input.kind === "touch");
  }

  private keep(input: PointerInput): PointerInput {
    this.down.set(input.id, input);
    return input;
  }

  /** The button stays that of the press. */
  private keepIfDown(input: PointerInput): PointerInput {
    const pressed = this.down.get(input.id);
    if (pressed !== undefined) this.keep({ ...input, button: pressed.button });
    return input;
  }

  private releasedButton(event: PointerLike, pressed: PointerInput): PointerButton {
    const isControlClick = event.button === 0 && pressed.button === "secondary" && this.isApple;
    return isControlClick ? "secondary" : this.buttonOf(event);
  }

  private buttonOf(event: PointerLike): PointerButton {
    if (event.button === eraserButton || (event.buttons & eraserBit) !== 0) return "eraser";
    // As all of Apple's systems have it.
    if (this.isApple && kindOf(event) === "mouse" && event.button === 0 && event.ctrlKey) {
      return "secondary";
    }
    return buttonNames[event.button] ?? "none";
  }

  private input(
    event: PointerLike,
    corner: Corner,
    action: PointerInput["action"],
    button: PointerButton,
  ): PointerInput {
    const kind = kindOf(event);
    return {
      type: "pointer",
      action,
      kind,
      id: event.pointerId,
      button,
      x: event.clientX - corner.left,
      y: event.clientY - corner.top,
      pressure: kind === "pen" ? event.pressure : 0.5,
      timeS: event.timeStamp / 1000,
      modifiers: modifiersOf(event, this.isApple),
    };
  }
}
