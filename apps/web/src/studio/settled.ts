// SPDX-License-Identifier: Apache-2.0
import { effect, type ReadonlySignal } from "@preact/signals";
import type { SaveState } from "../protocol/messages";

/** Longer than this, nobody should wait for a core at work or a disk. */
const mostMs = 2000;

/**
 * Resolves when the core has answered all that was sent, and what came of it is on the disk or will not come there.
 *
 * in      sent: number of the last event; answered: that of the last one that a frame has told of
 */
export function settled(
  sent: number,
  answered: ReadonlySignal<number>,
  saveState: ReadonlySignal<SaveState>,
): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (answered.value >= sent && saveState.value.kind !== "saving") resolve();
    });
    setTimeout(() => {
      stop();
      resolve();
    }, mostMs);
  });
}
