// SPDX-License-Identifier: Apache-2.0
import type { JournalStore } from "../storage/journal-store";
import type { CoreEngine } from "./engine";

const idleMs = 1500;
const pictureSidePx = 240;

/** Keeps the name and picture of a session up to date, when the hand rests: drawing the picture takes longer than a frame. */
export interface IdleDescriber {
  changed(): void;
}

export function describeWhenIdle(engine: CoreEngine, store: JournalStore): IdleDescriber {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const describe = () => {
    store.describe(engine.state().fileName, engine.picture(pictureSidePx));
  };
  return {
    changed() {
      clearTimeout(timer);
      timer = setTimeout(describe, idleMs);
    },
  };
}
