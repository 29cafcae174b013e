// SPDX-License-Identifier: Apache-2.0
import { signal, type ReadonlySignal } from "@preact/signals";

function matching(query: string): ReadonlySignal<boolean> {
  const list = matchMedia(query);
  const matches = signal(list.matches);
  list.addEventListener("change", (event) => {
    matches.value = event.matches;
  });
  return matches;
}

/** Too little room for all there is: a phone, a small window, a page at 200 %. As in shell.css. */
export const isNarrow = matching("(width < 900px), (height < 480px)");

/** Fingers: there may be no keys to tell of. */
export const isCoarse = matching("(pointer: coarse)");
