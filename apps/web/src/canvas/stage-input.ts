// SPDX-License-Identifier: Apache-2.0
import type { GestureInput, PointerInput, WheelInput } from "../protocol/events";
import { PointerInputs, type Corner } from "./pointer-inputs";
import { GestureInputs, wheelInput, type WebKitGesture } from "./wheel-inputs";

export interface StageInputListener {
  pointer(input: PointerInput): void;
  /** Where a pointer may be next. */
  predicted(inputs: readonly PointerInput[]): void;
  /** The pointer has left the view. */
  left(): void;
  other(event: WheelInput | GestureInput): void;
  spaceHeld(isHeld: boolean): void;
  /** Keys and buttons elsewhere that may end what a pointer is doing. */
  interrupted(): void;
}

const space = " ";
const modifierKeys = ["Shift", "Control", "Alt", "Meta"];

/** Keys typed there are theirs. */
function takesKeys(target: EventTarget | null): boolean {
  return (
    target instanceof Element &&
    target.closest("input, textarea, select, button, a, [contenteditable], [role=menu]") !== null
  );
}

/** Listens to the pointers of an element, and tells them in the core's words. */
export class StageInput {
  private readonly pointers: PointerInputs;
  private readonly gestures = new GestureInputs();
  private readonly ending = new AbortController();
  private isSpaceHeld = false;

  constructor(
    private readonly view: HTMLElement,
    private readonly listener: StageInputListener,
    private readonly isApple: boolean,
  ) {
    this.pointers = new PointerInputs(isApple);
    this.listenToPointers();
    this.listenToWheels();
    this.listenToWindow();
  }

  dispose(): void {
    this.ending.abort();
  }

  private get corner(): Corner {
    return this.view.getBoundingClientRect();
  }

  private listenToPointers(): void {
    const { view } = this;
    const { signal } = this.ending;
    const on = (type: PointerEventName, take: (event: PointerEvent) => void): void => {
      view.addEventListener(type, take, { signal });
    };
    on("pointerdown", (event) => {
      this.press(event);
    });
    on("pointermove", (event) => {
      this.move(event);
    });
    on("pointerup", (event) => {
      this.tell(this.pointers.release(event, this.corner));
    });
    const cancel = (event: PointerEvent): void => {
      this.tell(this.pointers.cancel(event.pointerId, event.timeStamp / 1000));
    };
    on("pointercancel", cancel);
    on("lostpointercapture", cancel);
    on("pointerleave", () => {
      this.listener.left();
    });
    const refuse = (event: Event): void => {
      event.preventDefault();
    };
    for (const type of ["contextmenu", "dragstart", "selectstart"]) {
      view.addEventListener(type, refuse, { signal });
    }
    // Else iPads take a pen's writing for text, and a middle button scrolls.
    view.addEventListener("touchmove", refuse, { signal, passive: false });
    view.addEventListener(
      "mousedown",
      (event) => {
        if (event.button === 1) event.preventDefault();
      },
      { signal },
    );
  }

  private press(event: PointerEvent): void {
    // A pointer that was made by a script cannot be captured.
    if (event.isTrusted) this.view.setPointerCapture(event.pointerId);
    this.tell(this.pointers.press(event, this.corner));
  }

  private move(event: PointerEvent): void {
    const { corner, pointers } = this;
    const isDown = pointers.isDown(event.pointerId);
    const coalesced =
      isDown && event.button < 0 && "getCoalescedEvents" in event ? event.getCoalescedEvents() : [];
    for (const each of coalesced.length > 0 ? coalesced : [event]) {
      this.tell(pointers.move(each, corner));
    }
    if (!isDown || !("getPredictedEvents" in event)) return;
    const predicted = event.getPredictedEvents();
    if (predicted.length === 0) return;
    this.listener.predicted(predicted.map((each) => pointers.guess(each, corner)));
  }

  private tell(input: PointerInput | null): void {
    if (input !== null) this.listener.pointer(input);
  }

  private listenToWheels(): void {
    const { view } = this;
    const options = { signal: this.ending.signal, passive: false };
    view.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.listener.other(wheelInput(event, this.corner, view.clientHeight, this.isApple));
      },
      options,
    );
    const onGesture = (type: string, take: (event: WebKitGesture) => void): void => {
      view.addEventListener(
        type,
        (event) => {
          event.preventDefault();
          take(event as WebKitGesture);
        },
        options,
      );
    };
    onGesture("gesturestart", (event) => {
      this.gestures.start(event);
    });
    onGesture("gesturechange", (event) => {
      const step = this.gestures.change(event, this.corner);
      // Fingers on the screen come as pointers too; those of a trackpad come only so.
      if (!this.pointers.hasFingers) this.listener.other(step);
    });
  }

  private listenToWindow(): void {
    const { signal } = this.ending;
    const options = { signal, capture: true };
    window.addEventListener(
      "keydown",
      (event) => {
        if (takesKeys(event.target)) return;
        if (event.key === space) this.holdSpace(true);
        else if (!modifierKeys.includes(event.key)) this.listener.interrupted();
      },
      options,
    );
    window.addEventListener(
      "keyup",
      (event) => {
        if (event.key === space) this.holdSpace(false);
      },
      options,
    );
    const leave = (event: Event): void => {
      this.leave(event.timeStamp / 1000);
    };
    window.addEventListener("blur", leave, { signal });
    document.addEventListener("visibilitychange", leave, { signal });
  }

  private holdSpace(isHeld: boolean): void {
    if (isHeld === this.isSpaceHeld) return;
    this.isSpaceHeld = isHeld;
    this.listener.spaceHeld(isHeld);
  }

  /** What is let go while the window is not there would never be told. */
  private leave(timeS: number): void {
    for (const input of this.pointers.cancelAll(timeS)) this.listener.pointer(input);
    this.listener.left();
    this.holdSpace(false);
  }
}

type PointerEventName =
  | "pointerdown"
  | "pointermove"
  | "pointerup"
  | "pointercancel"
  | "pointerleave"
  | "lostpointercapture";
