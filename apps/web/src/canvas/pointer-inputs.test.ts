// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { PointerInputs, type PointerLike } from "./pointer-inputs";
import { GestureInputs, wheelInput, type WheelLike } from "./wheel-inputs";

const corner = { left: 10, top: 20 };
const mouse: PointerLike = {
  pointerId: 1,
  pointerType: "mouse",
  button: 0,
  buttons: 1,
  clientX: 110,
  clientY: 220,
  pressure: 0,
  timeStamp: 1500,
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
};
const moved: PointerLike = { ...mouse, button: -1 };

describe("pointers", () => {
  it("are told in px of the view and in seconds, a mouse with half the pressure", () => {
    expect(new PointerInputs(false).press(mouse, corner)).toMatchObject({
      action: "press",
      kind: "mouse",
      button: "primary",
      x: 100,
      y: 200,
      pressure: 0.5,
      timeS: 1.5,
    });
  });

  it("have the pressure, the button and the other end of a pen", () => {
    const pen = { ...mouse, pointerType: "pen", pressure: 0.7 };
    const inputs = new PointerInputs(false);
    expect(inputs.press(pen, corner)).toMatchObject({ kind: "pen", pressure: 0.7 });
    expect(inputs.press({ ...pen, button: 2, buttons: 2 }, corner).button).toBe("secondary");
    expect(inputs.press({ ...pen, button: 5, buttons: 32 }, corner).button).toBe("eraser");
  });

  it("tell a second button of a mouse as a press and a release", () => {
    const inputs = new PointerInputs(false);
    inputs.press(mouse, corner);
    const right = inputs.move({ ...mouse, button: 2, buttons: 3 }, corner);
    expect(right).toMatchObject({ action: "press", button: "secondary" });
    const left = inputs.move({ ...mouse, button: 0, buttons: 2 }, corner);
    expect(left).toMatchObject({ action: "release", button: "primary" });
  });

  it("leave a pen's line alone when its button is pressed on the way", () => {
    const pen = { ...mouse, pointerType: "pen" };
    const inputs = new PointerInputs(false);
    inputs.press(pen, corner);
    expect(inputs.move({ ...pen, button: 2, buttons: 3 }, corner).action).toBe("move");
    expect(inputs.release({ ...pen, buttons: 0 }, corner)?.button).toBe("primary");
  });

  it("are released or cancelled once", () => {
    const inputs = new PointerInputs(false);
    inputs.press(mouse, corner);
    inputs.move({ ...moved, clientX: 120 }, corner);
    expect(inputs.cancel(1, 2)).toMatchObject({ action: "cancel", x: 110, timeS: 2 });
    expect(inputs.cancel(1, 2)).toBeNull();
    expect(inputs.release(mouse, corner)).toBeNull();
  });

  it("are all cancelled together", () => {
    const inputs = new PointerInputs(false);
    inputs.press({ ...mouse, pointerType: "touch", pointerId: 4 }, corner);
    inputs.press({ ...mouse, pointerType: "touch", pointerId: 5 }, corner);
    expect(inputs.hasFingers).toBe(true);
    expect(inputs.cancelAll(3).map((input) => input.id)).toEqual([4, 5]);
    expect(inputs.hasFingers).toBe(false);
  });

  it("of Apple's systems have Cmd for Ctrl, and Ctrl with a click for the right button", () => {
    const inputs = new PointerInputs(true);
    const click = inputs.press({ ...mouse, ctrlKey: true }, corner);
    expect(click).toMatchObject({ button: "secondary", modifiers: { isCtrl: false } });
    expect(inputs.release(mouse, corner)?.button).toBe("secondary");
    expect(inputs.press({ ...mouse, metaKey: true }, corner).modifiers.isCtrl).toBe(true);
  });
});

describe("wheels", () => {
  const wheel: WheelLike = { ...mouse, deltaX: 0, deltaY: 3, deltaMode: 0 };

  it("count in px, lines or pages", () => {
    const delta = (deltaMode: number) =>
      wheelInput({ ...wheel, deltaMode }, corner, 700, false).deltaY;
    expect([0, 1, 2].map(delta)).toEqual([3, 100, 2100]);
  });

  it("with Ctrl are a trackpad's pinch on Apple's systems too", () => {
    expect(wheelInput({ ...wheel, ctrlKey: true }, corner, 700, true).modifiers.isCtrl).toBe(true);
  });
});

describe("WebKit's gestures", () => {
  it("are told step by step", () => {
    const gestures = new GestureInputs();
    gestures.start({ scale: 1, clientX: 100, clientY: 100 });
    gestures.change({ scale: 2, clientX: 100, clientY: 100 }, corner);
    expect(gestures.change({ scale: 3, clientX: 105, clientY: 98 }, corner)).toEqual({
      type: "gesture",
      x: 95,
      y: 78,
      scale: 1.5,
      movedX: 5,
      movedY: -2,
    });
  });
});
