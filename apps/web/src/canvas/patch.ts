// SPDX-License-Identifier: Apache-2.0

/** A bitmap for a piece of a sheet while it is painted anew. */
export class Patch {
  private readonly context: CanvasRenderingContext2D;

  constructor() {
    const context = document.createElement("canvas").getContext("2d");
    if (context === null) throw new Error("this browser has no canvas to draw on");
    this.context = context;
  }

  /** Clear, at least this large: whole device px. Counts until the next one is asked for. */
  blank(width: number, height: number): CanvasRenderingContext2D {
    const { canvas } = this.context;
    if (canvas.width < width || canvas.height < height) {
      canvas.width = Math.max(canvas.width, width);
      canvas.height = Math.max(canvas.height, height);
    } else {
      this.context.resetTransform();
      this.context.clearRect(0, 0, width, height);
    }
    return this.context;
  }
}
