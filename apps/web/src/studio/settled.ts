// SPDX-License-Identifier: Apache-2.0
import type { ReadonlySignal } from "@preact/signals";
import type { SaveState } from "../protocol/messages";

/** Longer than this, nobody should wait for a disk. */
const mostMs = 1000;

/** Resolves when what is being written is on the disk, or will not come there. */
export function settled(saveState: ReadonlySignal<SaveState>): Promise<void> {
  return new Promise((resolve) => {
    const stop = saveState.subscribe((state) => {
      if (state.kind !== "saving") resolve();
    });
    setTimeout(() => {
      stop();
      resolve();
    }, mostMs);
  });
}
