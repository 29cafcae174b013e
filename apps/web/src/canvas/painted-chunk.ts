// SPDX-License-Identifier: Apache-2.0
import { readDrawList } from "../protocol/draw-list";
import type { ChunkUpdate } from "../protocol/scene";
import { paintedItem, type Context, type PaintedItem } from "./painted-item";
import { common, isEmpty, joined, nowhere, type Box } from "./places";

/** A chunk with what was made of it for a canvas. */
export class PaintedChunk {
  readonly id: number;
  readonly space: ChunkUpdate["space"];
  readonly cost: number;
  private readonly items: readonly PaintedItem[];

  constructor(update: ChunkUpdate & { readonly list: Uint8Array }) {
    this.id = update.id;
    this.space = update.space;
    this.items = readDrawList(update.list).map(paintedItem);
    this.cost = this.items.reduce((sum, item) => sum + item.cost, 0);
  }

  /** px of the list. */
  box(scale: number): Box {
    return this.items.reduce((box, item) => joined(box, item.box(scale)), nowhere);
  }

  /** Draws what may be seen through a window, in px of the list. */
  paint(context: Context, scale: number, window: Box): void {
    for (const item of this.items) {
      if (!isEmpty(common(item.box(scale), window))) item.paint(context, scale);
    }
  }
}
