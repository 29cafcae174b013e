// SPDX-License-Identifier: Apache-2.0
import type { Outcome } from "../protocol/messages";
import type { ModelMesh, ModelUpdate } from "../protocol/scene";
import type { GpuModel } from "./gpu-model";
import { ModelPainter } from "./model-painter";
import type { ViewSize } from "./placement";
import { risingPose, standingPose } from "./pose";
import type { Pose } from "./pose";
import { isOver, riseMs, riseTime } from "./rise";
import type { Direction, Motion } from "./rise";

const contextWishes: WebGLContextAttributes = {
  alpha: true,
  premultipliedAlpha: true,
  antialias: true,
  depth: true,
  stencil: false,
  preserveDrawingBuffer: false,
};

/** After so long without a change there is time for a fine picture. */
const restMs = 200;

/**
 * Shows the inflated model on a transparent canvas of its own, over the paper.
 *
 * When the model appears, the drawing rises from the paper; when it goes, it lies down again, and the canvas is hidden. It paints once
 * for each change, and at rest not at all. A lost context comes back by itself: the last mesh is kept.
 */
export class ModelView {
  private readonly canvas: HTMLCanvasElement;
  private readonly gl: WebGL2RenderingContext;
  private readonly listening = new AbortController();
  /** null: not needed yet, or the context is lost. */
  private painter: ModelPainter | null = null;
  private size: ViewSize = { width: 1, height: 1 };
  private ratio = 1;
  private isMotionReduced = false;
  /** The last ones: they stay when the model goes, for the way back to the paper. */
  private update: ModelUpdate | null = null;
  private mesh: ModelMesh | null = null;
  private isWanted = false;
  private motion: Motion | null = null;
  /** When the motion's first picture was painted; uploads before it take no time from it. */
  private motionStartMs: number | null = null;
  /** How far the rise has come. */
  private riseTimeMs = 0;
  private request = 0;
  /** The machine cannot keep up: rougher pictures, until nothing has changed for a while. */
  private isHurried = false;
  private rest = 0;

  /** Fails where the browser has no WebGL 2, or keeps it off. */
  static open(canvas: HTMLCanvasElement): Outcome<ModelView> {
    const gl = canvas.getContext("webgl2", contextWishes);
    return gl
      ? { ok: true, value: new ModelView(canvas, gl) }
      : { ok: false, why: "this browser offers no WebGL 2" };
  }

  private constructor(canvas: HTMLCanvasElement, gl: WebGL2RenderingContext) {
    this.canvas = canvas;
    this.gl = gl;
    const { signal } = this.listening;
    canvas.addEventListener("webglcontextlost", this.lose, { signal });
    canvas.addEventListener("webglcontextrestored", this.schedule, { signal });
    this.hide();
  }

  /** null: back to the drawing. */
  show(update: ModelUpdate | null): void {
    if (!update) {
      if (this.isWanted) this.leave();
      return;
    }
    this.mesh = update.mesh ?? this.mesh;
    // The mesh is held once, so that an old one can go.
    this.update = { ...update, mesh: null };
    if (!this.isWanted) this.enter();
    this.schedule();
  }

  /** px of the page, and px of the display for one of them. */
  resize(width: number, height: number, ratio: number): void {
    this.size = { width: Math.max(width, 1), height: Math.max(height, 1) };
    this.ratio = ratio;
    this.canvas.width = Math.max(Math.round(width * ratio), 1);
    this.canvas.height = Math.max(Math.round(height * ratio), 1);
    // A canvas is empty after a change of size; at the next frame it would be seen so.
    this.paint();
  }

  setReducedMotion(isReduced: boolean): void {
    this.isMotionReduced = isReduced;
    if (!isReduced || !this.motion) return;
    this.finish(this.motion.direction);
    this.schedule();
  }

  dispose(): void {
    this.listening.abort();
    cancelAnimationFrame(this.request);
    this.request = 0;
    clearTimeout(this.rest);
    this.painter?.dispose();
    this.painter = null;
    this.hide();
  }

  private enter(): void {
    this.isWanted = true;
    this.canvas.style.visibility = "visible";
    this.move("rise");
  }

  private leave(): void {
    this.isWanted = false;
    this.move("fall");
    this.schedule();
  }

  private move(direction: Direction): void {
    if (this.isMotionReduced) {
      this.finish(direction);
      return;
    }
    const partCount = Math.max(this.mesh?.layerCount ?? 1, 1);
    this.motion = { direction, fromMs: this.riseTimeMs, partCount };
    this.motionStartMs = null;
  }

  private finish(direction: Direction): void {
    this.riseTimeMs = direction === "rise" ? riseMs(this.mesh?.layerCount ?? 1) : 0;
    this.motion = null;
    if (direction === "fall") this.hide();
  }

  private hide(): void {
    this.canvas.style.visibility = "hidden";
  }

  private advance(timeMs: number): void {
    if (!this.motion) return;
    const elapsed = Math.max(timeMs - (this.motionStartMs ?? timeMs), 0);
    this.riseTimeMs = riseTime(this.motion, elapsed);
    if (isOver(this.motion, elapsed)) this.finish(this.motion.direction);
  }

  private pose(model: GpuModel, update: ModelUpdate): Pose {
    if (!this.motion) return standingPose(update, model.extent, this.size);
    return risingPose(update, model.extent, model.partCount, this.size, this.riseTimeMs);
  }

  private paint(): void {
    const isVisible = this.isWanted || this.motion !== null;
    if (!isVisible || !this.update || !this.mesh || this.gl.isContextLost()) return;
    this.painter ??= new ModelPainter(this.gl);
    const model = this.painter.model(this.mesh);
    const care = this.isHurried ? "quick" : "fine";
    this.painter.paint(model, this.update, this.pose(model, this.update), this.ratio, care);
  }

  private hurry(): void {
    if (this.painter?.isBehind) this.isHurried = true;
    if (!this.isHurried) return;
    clearTimeout(this.rest);
    this.rest = window.setTimeout(() => {
      this.isHurried = false;
      this.paint();
    }, restMs);
  }

  private readonly schedule = (): void => {
    if (this.request !== 0) return;
    this.request = requestAnimationFrame((timeMs) => {
      this.request = 0;
      this.advance(timeMs);
      this.hurry();
      this.paint();
      if (!this.motion) return;
      this.motionStartMs ??= performance.now();
      this.schedule();
    });
  };

  private readonly lose = (event: Event): void => {
    // Without this it would never be restored.
    event.preventDefault();
    this.painter = null;
  };
}
