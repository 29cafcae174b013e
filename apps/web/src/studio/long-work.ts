// SPDX-License-Identifier: Apache-2.0
import { signal, type ReadonlySignal } from "@preact/signals";
import type { LongWork } from "./studio";

/** Shorter work is over before it could be read. */
const shownAfterMs = 100;

/** Tells when the core has been at work for long: it says what it is at, and is asked whether it has answered. */
export class WorkWatch {
  private readonly work = signal<LongWork | null>(null);
  private timer: ReturnType<typeof setTimeout> | undefined;
  private latest: LongWork | null = null;

  get longWork(): ReadonlySignal<LongWork | null> {
    return this.work;
  }

  /** A stage has begun or goes on. */
  progress(stage: string, share: number): void {
    this.latest = { stage, share };
    if (this.work.value !== null) this.work.value = this.latest;
    else this.timer ??= setTimeout(() => (this.work.value = this.latest), shownAfterMs);
  }

  /** The core has answered. */
  over(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.latest = null;
    this.work.value = null;
  }
}
