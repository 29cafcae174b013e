// SPDX-License-Identifier: Apache-2.0
import type { PointerInput } from "../protocol/events";
import type { Rgba } from "../protocol/scene";
import type { EngineState } from "../protocol/state";
import type { WetLines, WetLook, WetPoint } from "./wet-lines";

/** What decides whether and how a pointer draws. */
export interface PenSetting {
  readonly state: Pick<EngineState, "mode" | "tool" | "brushPx" | "ink">;
  /** px of the screen for one of the canvas. */
  readonly zoom: number;
  readonly isSpaceHeld: boolean;
}

/** As src/render/ink_line.cpp: the width of a line drawn without any pressure, as a share of the full width. */
const lightestPress = 0.4;
/** As src/editor/scene_strokes: no rough line is thinner, px of the screen; and what is far is pale. */
const thinnestPx = 0.75;
const farShare = 0.45;
/** As src/render/palette.h, red in the lowest byte. */
const helpLine: Rgba = 0xff7d8a1f;
/** As src/editor/finger_gesture.cpp: before and after a pen's event a touch is its hand's. */
const palmS = 0.5;

/** "#rrggbb" as red in the lowest byte, opaque. */
function rgbaOf(text: string): Rgba {
  const value = Number.parseInt(text.slice(1, 7), 16);
  const [red, green, blue] = [value >>> 16, (value >>> 8) & 0xff, value & 0xff];
  return (red | (green << 8) | (blue << 16) | (0xff << 24)) >>> 0;
}

function faded(colour: Rgba, share: number): Rgba {
  return ((colour & 0xffffff) | (Math.round((colour >>> 24) * share) << 24)) >>> 0;
}

function lookOf(input: PointerInput, { state, zoom }: PenSetting): WetLook {
  const isHelpLine = state.tool === "help_line";
  const colour = isHelpLine ? helpLine : rgbaOf(state.ink);
  return {
    colour: input.button === "secondary" ? faded(colour, farShare) : colour,
    widthPx: state.brushPx * zoom,
    isDashed: isHelpLine,
  };
}

export function wetPoint(input: PointerInput, look: WetLook): WetPoint {
  const press = input.kind === "pen" ? Math.min(Math.max(input.pressure, 0), 1) : 1;
  const widthPx = look.widthPx * (lightestPress + (1 - lightestPress) * press);
  return { place: [input.x, input.y], widthPx: Math.max(widthPx, thinnestPx) };
}

/** Guesses which pointers draw, as src/editor/route_pointer.cpp decides it: what it is not sure of, the core alone draws. */
export class WetPen {
  private readonly fingers = new Set<number>();
  private wasPenDown = false;
  private lastPenS = Number.NEGATIVE_INFINITY;

  constructor(private readonly lines: WetLines) {}

  hear(input: PointerInput, sequence: number, setting: PenSetting): void {
    if (input.kind === "pen") this.hearPen(input);
    switch (input.action) {
      case "press":
        this.press(input, sequence, setting);
        return;
      case "move":
        this.add(input, sequence);
        return;
      case "release":
        this.fingers.delete(input.id);
        this.release(input, sequence);
        return;
      case "cancel":
        this.fingers.delete(input.id);
        this.lines.drop(input.id);
        return;
    }
  }

  predict(inputs: readonly PointerInput[]): void {
    const id = inputs[0]?.id ?? -1;
    const look = this.lines.look(id);
    if (look === null) return;
    this.lines.predict(
      id,
      inputs.map((input) => wetPoint(input, look)),
    );
  }

  /** Something else has come to the core, which may end or drop what is being drawn. */
  giveUp(): void {
    this.lines.dropAll();
  }

  /** Touches from now on, and shortly before, are the pen's hand. */
  private hearPen(input: PointerInput): void {
    this.lastPenS = input.timeS;
    if (input.action === "press") this.wasPenDown = true;
    for (const finger of this.fingers) this.lines.drop(finger);
  }

  private press(input: PointerInput, sequence: number, setting: PenSetting): void {
    if (input.kind === "touch") {
      this.fingers.add(input.id);
      if (this.fingers.size > 1) for (const finger of this.fingers) this.lines.drop(finger);
      if (this.fingers.size > 1 || this.lines.isAnyGoing || this.isBesidePen(input)) return;
    } else {
      // One takes over from another; what was drawn stays.
      this.lines.endAll();
    }
    if (!draws(input, setting)) return;
    const look = lookOf(input, setting);
    this.lines.begin(input.id, look, wetPoint(input, look), sequence);
  }

  private isBesidePen(finger: PointerInput): boolean {
    return this.wasPenDown || finger.timeS - this.lastPenS < palmS;
  }

  private add(input: PointerInput, sequence: number): void {
    const look = this.lines.look(input.id);
    if (look === null) return;
    if (input.modifiers.isShift) {
      this.lines.drop(input.id);
    } else {
      this.lines.add(input.id, wetPoint(input, look), sequence);
    }
  }

  /** A pen that is lifted presses no more: the line keeps the width that it had. */
  private release(input: PointerInput, sequence: number): void {
    const width = this.lines.lastWidthPx(input.id);
    if (width === null) return;
    this.lines.add(input.id, { place: [input.x, input.y], widthPx: width }, sequence);
    this.lines.end(input.id);
  }
}

function draws(input: PointerInput, { state, isSpaceHeld }: PenSetting): boolean {
  const isInk = state.tool === "brush" || state.tool === "help_line";
  const isButton = input.button === "primary" || input.button === "secondary";
  // With Shift the line is straight and all of it moves.
  return state.mode === "draw" && isInk && isButton && !isSpaceHeld && !input.modifiers.isShift;
}
