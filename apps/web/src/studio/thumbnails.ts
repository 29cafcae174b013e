// SPDX-License-Identifier: Apache-2.0
import { signal, type ReadonlySignal, type Signal } from "@preact/signals";
import type { FromWorker, ToWorker } from "../protocol/messages";
import type { Thumbnail } from "./studio";

const sidePx = 96;

/** Pictures of parts, asked for when a part has come to look different; the old one stays until the new one is there. */
export class Thumbnails {
  private readonly known = new Map<number, { asked: number; shown: Signal<Thumbnail | null> }>();

  constructor(private readonly ask: (message: ToWorker) => void) {}

  of(layer: number, look: number): ReadonlySignal<Thumbnail | null> {
    let entry = this.known.get(layer);
    if (entry === undefined) {
      entry = { asked: -1, shown: signal(null) };
      this.known.set(layer, entry);
    }
    if (entry.asked !== look) {
      entry.asked = look;
      this.ask({ kind: "thumbnail", layer, look, sizePx: sidePx });
    }
    return entry.shown;
  }

  take(message: Extract<FromWorker, { kind: "thumbnail" }>): void {
    const entry = this.known.get(message.layer);
    if (entry === undefined) return;
    const pixels = new Uint8ClampedArray(message.pixels);
    entry.shown.value = {
      look: message.look,
      image: new ImageData(pixels, message.width, message.height),
    };
  }

  /** A worker that starts has been asked for nothing. */
  askAgain(): void {
    for (const entry of this.known.values()) entry.asked = -1;
  }
}
