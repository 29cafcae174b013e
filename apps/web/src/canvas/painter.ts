// SPDX-License-Identifier: Apache-2.0
import type { AffineNumbers, ChunkUpdate, SceneUpdate } from "../protocol/scene";
import { PaintedChunk } from "./painted-chunk";
import { unmoved } from "./places";
import { Patch } from "./patch";
import { Sheet } from "./sheet";
import { splitChunks } from "./split-chunks";

/** A chunk that is read when it is first painted. */
interface KeptChunk {
  readonly list: Uint8Array;
  readonly update: ChunkUpdate;
  painted: PaintedChunk | null;
}

/**
 * Paints scenes on three sheets that lie over one another: the ground, which is cheap; the middle, which keeps what stays the same;
 * and the top, where something changes from frame to frame.
 */
export class Painter {
  private readonly patch = new Patch();
  private readonly ground = new Sheet(this.patch);
  private readonly middle = new Sheet(this.patch);
  private readonly top = new Sheet(this.patch);
  private readonly kept = new Map<number, KeptChunk>();
  private order: readonly number[] = [];
  private shown = new Set<number>();
  private toScreen: AffineNumbers = unmoved;
  private pixelRatio = 1;

  /** Back to front. */
  get canvases(): readonly HTMLCanvasElement[] {
    return [this.ground, this.middle, this.top].map((sheet) => sheet.canvas);
  }

  /** Takes in a scene; chunks that it does not show are forgotten, as the worker expects. */
  accept(scene: SceneUpdate): void {
    for (const update of scene.chunks) {
      if (update.list !== null) {
        this.kept.set(update.id, { update, list: update.list, painted: null });
      }
    }
    this.order = scene.chunks.map((chunk) => chunk.id);
    const wanted = new Set(this.order);
    for (const id of this.kept.keys()) if (!wanted.has(id)) this.kept.delete(id);
    this.toScreen = scene.canvasToScreen;
  }

  /** CSS px. */
  resize(width: number, height: number, pixelRatio: number): void {
    this.pixelRatio = pixelRatio;
    for (const sheet of [this.ground, this.middle, this.top]) {
      sheet.resize(
        Math.max(1, Math.round(width * pixelRatio)),
        Math.max(1, Math.round(height * pixelRatio)),
      );
    }
  }

  /** Paints the last scene. Returns whether all is exactly in its place: see Sheet.show. */
  paint(isAtRest: boolean): boolean {
    const chunks = this.order.flatMap((id) => this.chunk(id) ?? []);
    const [from, to] = splitChunks(
      chunks.map((chunk) => ({
        cost: chunk.cost,
        isOld: this.shown.has(chunk.id),
        isInMiddle: this.middle.has(chunk),
      })),
    );
    this.shown = new Set(this.order);
    const show = (sheet: Sheet, part: readonly PaintedChunk[]): boolean =>
      sheet.show(part, this.toScreen, this.pixelRatio, isAtRest);
    const exact = [
      show(this.ground, chunks.slice(0, from)),
      show(this.middle, chunks.slice(from, to)),
      show(this.top, chunks.slice(to)),
    ];
    return exact.every(Boolean);
  }

  private chunk(id: number): PaintedChunk | null {
    const kept = this.kept.get(id);
    if (kept === undefined) return null;
    kept.painted ??= new PaintedChunk({ ...kept.update, list: kept.list });
    return kept.painted;
  }
}
