// SPDX-License-Identifier: Apache-2.0
import type { AffineNumbers } from "../protocol/scene";
import type { Context } from "./painted-item";
import type { PaintedChunk } from "./painted-chunk";
import {
  area,
  common,
  composed,
  enlarged,
  grown,
  hasSameForm,
  inverse,
  isEmpty,
  joined,
  mapped,
  meanScale,
  nowhere,
  roundedOut,
  shifted,
  unmapped,
  unmoved,
  type Box,
} from "./places";
import type { Patch } from "./patch";
import { sheetChanges } from "./sheet-changes";

/** From here on all is painted anew: it costs no more than the rest would. */
const mostDirtyShare = 0.7;
/** So many points are painted in one frame while the paper is zoomed; more of them are stretched for so many frames more. */
const mostPerFrame = 8000;
/** What anti-aliasing may touch beyond a box, device px. */
const softEdgePx = 2;

/** How the canvas lies on the sheet. */
interface Placing {
  /** From canvas px to device px. */
  readonly map: AffineNumbers;
  readonly pixelRatio: number;
}

/**
 * A transparent bitmap that keeps what was painted: when its content moves it is shifted, and only what has changed or come into
 * view is painted again.
 */
export class Sheet {
  readonly canvas = document.createElement("canvas");
  private readonly context: CanvasRenderingContext2D;
  private chunks: readonly PaintedChunk[] = [];
  private placing: Placing = { map: unmoved, pixelRatio: 1 };
  private isBlank = true;
  /** For how many frames it has been stretched instead of being painted. */
  private stretchedFrames = 0;

  /** patch: shared by sheets that are painted one after another. */
  constructor(private readonly patch: Patch) {
    const context = this.canvas.getContext("2d");
    if (context === null) throw new Error("this browser has no canvas to draw on");
    this.context = context;
  }

  has(chunk: PaintedChunk): boolean {
    return this.chunks.includes(chunk);
  }

  /** Device px. */
  resize(width: number, height: number): void {
    if (this.canvas.width === width && this.canvas.height === height) return;
    this.canvas.width = width;
    this.canvas.height = height;
    this.isBlank = true;
  }

  /**
   * Shows chunks, back to front. In motion they may lie up to half a device px beside their place, or be stretched from another
   * scale; isAtRest: exactly there. Returns whether they are.
   */
  show(
    chunks: readonly PaintedChunk[],
    toScreen: AffineNumbers,
    pixelRatio: number,
    isAtRest: boolean,
  ): boolean {
    const wanted = { map: enlarged(toScreen, pixelRatio), pixelRatio };
    if (!isAtRest && this.stretch(chunks, wanted)) return false;
    if (this.stretchedFrames > 0) this.canvas.style.transform = "none";
    this.stretchedFrames = 0;
    if (!this.adapt(chunks, wanted, isAtRest)) this.paintAll(chunks, wanted);
    this.chunks = chunks;
    this.isBlank = false;
    return chunks.length === 0 || offset(this.placing.map, wanted.map) === 0;
  }

  private get whole(): Box {
    return { left: 0, top: 0, right: this.canvas.width, bottom: this.canvas.height };
  }

  /** Where all would have to be painted at another scale: shows what was painted at the last one. false: it is to be painted. */
  private stretch(chunks: readonly PaintedChunk[], wanted: Placing): boolean {
    const { map, pixelRatio } = this.placing;
    const isOther =
      this.isBlank ||
      pixelRatio !== wanted.pixelRatio ||
      chunks.length !== this.chunks.length ||
      chunks.some((chunk, i) => chunk !== this.chunks[i]);
    const back = inverse(map);
    if (isOther || back === null || hasSameForm(map, wanted.map)) return false;
    const cost = chunks.reduce((sum, chunk) => sum + chunk.cost, 0);
    if (this.stretchedFrames >= Math.floor(cost / mostPerFrame)) return false;
    ++this.stretchedFrames;
    const [a, b, c, d, e, f] = composed(wanted.map, back);
    const css = [a, b, c, d, e / pixelRatio, f / pixelRatio];
    this.canvas.style.transform = `matrix(${css.join(", ")})`;
    return true;
  }

  /** false: it is better to paint all anew. */
  private adapt(chunks: readonly PaintedChunk[], wanted: Placing, isAtRest: boolean): boolean {
    const { map, pixelRatio } = this.placing;
    if (this.isBlank || pixelRatio !== wanted.pixelRatio || !hasSameForm(map, wanted.map)) {
      return false;
    }
    if (isAtRest && offset(map, wanted.map) !== 0) return false;
    const changes = sheetChanges(this.chunks, chunks);
    if (changes === null) return false;
    const x = Math.round(wanted.map[4] - map[4]);
    const y = Math.round(wanted.map[5] - map[5]);
    const isShifted = x !== 0 || y !== 0;
    const onScreen = isShifted ? changes.below.filter((chunk) => chunk.space === "screen") : [];
    const left = this.boxOf([...changes.removed, ...onScreen]);
    const placing = { map: moved(map, x, y), pixelRatio };
    this.placing = placing;
    const come = this.boxOf([...changes.inserted, ...onScreen]);
    const dirty = [joined(shifted(left, x, y), come), ...this.strips(x, y)]
      .map((box) => common(box, this.whole))
      .filter((box) => !isEmpty(box));
    const most = mostDirtyShare * area(this.whole);
    if (dirty.reduce((sum, box) => sum + area(box), 0) > most) return false;
    if (isShifted) this.shift(x, y);
    for (const box of dirty) this.repaint(changes.below, box);
    this.paint(changes.appended, this.whole);
    return true;
  }

  private paintAll(chunks: readonly PaintedChunk[], wanted: Placing): void {
    this.placing = wanted;
    this.clear(this.whole);
    this.paint(chunks, this.whole);
  }

  /** Where the sheet is bare after a shift. */
  private strips(x: number, y: number): Box[] {
    const { right, bottom } = this.whole;
    const left = x > 0 ? 0 : right + x;
    const top = y > 0 ? 0 : bottom + y;
    return [
      { left, top: 0, right: left + Math.abs(x), bottom },
      { left: 0, top, right, bottom: top + Math.abs(y) },
    ];
  }

  private shift(x: number, y: number): void {
    const { context } = this;
    context.resetTransform();
    context.globalCompositeOperation = "copy";
    context.drawImage(this.canvas, x, y);
    context.globalCompositeOperation = "source-over";
  }

  /**
   * By way of another bitmap and not within a clip: Chromium on a GPU forgets all else that was painted when a frame's last lines lie
   * within one.
   */
  private repaint(chunks: readonly PaintedChunk[], box: Box): void {
    const width = box.right - box.left;
    const height = box.bottom - box.top;
    const patch = this.patch.blank(width, height);
    this.paint(chunks, box, patch, [1, 0, 0, 1, -box.left, -box.top]);
    this.clear(box);
    this.context.drawImage(patch.canvas, 0, 0, width, height, box.left, box.top, width, height);
  }

  private clear(box: Box): void {
    this.context.resetTransform();
    this.context.clearRect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  }

  /** window: device px of the sheet. onto: from there to the context. */
  private paint(
    chunks: readonly PaintedChunk[],
    window: Box,
    context: Context = this.context,
    onto: AffineNumbers = unmoved,
  ): void {
    context.lineCap = "round";
    context.lineJoin = "round";
    const seen = grown(window, softEdgePx);
    for (const chunk of chunks) {
      const map = this.mapOf(chunk);
      context.setTransform(...composed(onto, map));
      chunk.paint(context, meanScale(map) / this.placing.pixelRatio, unmapped(seen, map));
    }
  }

  private mapOf(chunk: PaintedChunk): AffineNumbers {
    const { map, pixelRatio } = this.placing;
    return chunk.space === "canvas" ? map : enlarged(unmoved, pixelRatio);
  }

  /** Device px. */
  private boxOf(chunks: readonly PaintedChunk[]): Box {
    let box = nowhere;
    for (const chunk of chunks) {
      const map = this.mapOf(chunk);
      box = joined(box, mapped(chunk.box(meanScale(map) / this.placing.pixelRatio), map));
    }
    return roundedOut(grown(box, softEdgePx));
  }
}

function moved([a, b, c, d, e, f]: AffineNumbers, x: number, y: number): AffineNumbers {
  return [a, b, c, d, e + x, f + y];
}

/** How far a map is from another one, to what can be seen. */
function offset(map: AffineNumbers, wanted: AffineNumbers): number {
  const px = Math.max(Math.abs(map[4] - wanted[4]), Math.abs(map[5] - wanted[5]));
  return px < 0.02 ? 0 : px;
}
