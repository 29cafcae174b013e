// SPDX-License-Identifier: Apache-2.0
import type { CoreEvent, PointerInput } from "../protocol/events";
import type { Frame } from "../protocol/messages";
import type { AffineNumbers } from "../protocol/scene";
import type { EngineState } from "../protocol/state";
import "../styles/stage.css";
import { Cursor } from "./cursor";
import { Painter } from "./painter";
import { meanScale, unmoved } from "./places";
import { StageInput } from "./stage-input";
import { ViewSize } from "./view-size";
import { WetInk } from "./wet-ink";
import { WetLines } from "./wet-lines";
import { WetPen } from "./wet-pen";
import { viewOf } from "./window-view";

export interface StageOptions {
  /** Sends an event to the core; returns its number, which ascends. */
  readonly send: (event: CoreEvent) => number;
  /** What surrounds the canvas as it is now. */
  readonly state: EngineState;
  /** Cmd takes the place of Ctrl. */
  readonly isApple: boolean;
}

/** So long after the last change the paper is at rest, ms. */
const restMs = 120;

/**
 * The paper: paints the scenes of the core, draws the line of the pen before the core has it, and sends what pointers do. It fills
 * its host, which should have a position.
 */
export class Stage {
  private readonly view = document.createElement("div");
  private readonly painter = new Painter();
  private readonly wetLines = new WetLines();
  private readonly wetPen = new WetPen(this.wetLines);
  private readonly wetInk = new WetInk();
  private readonly cursor: Cursor;
  private readonly input: StageInput;
  private readonly size: ViewSize;
  private state: EngineState;
  private isSpaceHeld = false;
  private readonly down = new Set<number>();
  private toScreen: AffineNumbers = unmoved;
  /** Of the last frame, and whether it is painted. */
  private sequence = 0;
  private isPainted = true;
  private frameRequest = 0;
  private restTimer = 0;
  private lastResize = 0;

  constructor(
    host: HTMLElement,
    private readonly options: StageOptions,
  ) {
    this.state = options.state;
    this.view.className = "stage";
    this.cursor = new Cursor(this.view);
    this.view.append(...this.painter.canvases, this.wetInk.canvas, this.cursor.element);
    host.append(this.view);
    this.input = this.listen();
    this.size = new ViewSize(this.view, () => {
      this.takeSize();
    });
    this.updateCursor();
  }

  /** Takes in a frame of the core; it is painted with the screen's next one. */
  show(frame: Frame): void {
    this.sequence = frame.sequence;
    if (frame.state !== null) this.setTool(frame.state);
    if (frame.scene !== null) {
      this.painter.accept(frame.scene);
      this.toScreen = frame.scene.canvasToScreen;
      this.updateCursor();
      // A core that was started anew does not know how large the window is.
      const { width, height } = this.size;
      const isOther = frame.scene.width !== width || frame.scene.height !== height;
      if (isOther && frame.sequence >= this.lastResize) this.sendSize();
    }
    this.isPainted = false;
    this.requestPaint();
  }

  setTool(state: EngineState): void {
    this.state = state;
    this.updateCursor();
  }

  dispose(): void {
    cancelAnimationFrame(this.frameRequest);
    clearTimeout(this.restTimer);
    this.input.dispose();
    this.size.dispose();
    this.cursor.dispose();
    this.view.remove();
  }

  private get zoom(): number {
    return meanScale(this.toScreen);
  }

  private listen(): StageInput {
    return new StageInput(
      this.view,
      {
        pointer: (input) => {
          this.takePointer(input);
        },
        predicted: (inputs) => {
          this.wetPen.predict(inputs);
          this.drawWet();
        },
        left: () => {
          this.cursor.moveTo(null);
        },
        other: (event) => {
          this.options.send(event);
        },
        spaceHeld: (isHeld) => {
          this.isSpaceHeld = isHeld;
          this.updateCursor();
        },
        interrupted: () => {
          this.wetPen.giveUp();
          this.drawWet();
        },
      },
      this.options.isApple,
    );
  }

  private takePointer(input: PointerInput): void {
    const sequence = this.options.send(input);
    const { state, zoom, isSpaceHeld } = this;
    this.wetPen.hear(input, sequence, { state, zoom, isSpaceHeld });
    this.drawWet();
    if (input.action === "press") this.down.add(input.id);
    if (input.action === "release" || input.action === "cancel") this.down.delete(input.id);
    this.cursor.moveTo(input.kind === "touch" ? null : [input.x, input.y]);
    if (input.action !== "move") this.updateCursor();
  }

  private drawWet(): void {
    this.wetInk.draw(this.wetLines.tails());
  }

  private updateCursor(): void {
    const { state, zoom, isSpaceHeld } = this;
    this.cursor.set({ state, zoom, isSpaceHeld, isDown: this.down.size > 0 });
  }

  private takeSize(): void {
    const { width, height, pixelRatio } = this.size;
    this.painter.resize(width, height, pixelRatio);
    this.wetInk.resize(width, height, pixelRatio);
    this.sendSize();
    // Bitmaps are empty now, and the browser is about to show them.
    this.paint(true);
    this.drawWet();
  }

  private sendSize(): void {
    const { width, height } = this.size;
    if (width < 1 || height < 1) return;
    this.lastResize = this.options.send(viewOf(width, height));
  }

  private requestPaint(): void {
    if (this.frameRequest !== 0) return;
    this.frameRequest = requestAnimationFrame(() => {
      this.frameRequest = 0;
      if (this.isPainted) return;
      this.isPainted = true;
      this.paint(false);
      this.wetLines.takeIn(this.sequence);
      this.drawWet();
    });
  }

  private paint(isAtRest: boolean): void {
    clearTimeout(this.restTimer);
    const isExact = this.painter.paint(isAtRest);
    if (isExact) return;
    this.restTimer = window.setTimeout(() => {
      this.paint(true);
    }, restMs);
  }
}
