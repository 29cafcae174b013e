// SPDX-License-Identifier: Apache-2.0
import type { CoreEvent } from "../protocol/events";
import type { FromWorker } from "../protocol/messages";

interface Batch {
  readonly events: readonly CoreEvent[];
  readonly sequence: number;
}

/** What a worker was sent and has not answered: it may end before it does. */
export class Unanswered {
  private batches: readonly Batch[] = [];
  /** It does what it had put off: all that it was sent since lies still before it. */
  private isAtOwnWork = false;

  sent(events: readonly CoreEvent[], sequence: number): void {
    this.batches = [...this.batches, { events, sequence }];
  }

  heard(message: FromWorker): void {
    if (message.kind === "frame") {
      this.batches = this.batches.filter(({ sequence }) => sequence > message.sequence);
      this.isAtOwnWork = !message.isAtRest;
    } else if (message.kind === "progress" && message.share === null) {
      this.isAtOwnWork = false;
    }
  }

  /** Takes out what it has not begun, for another one. Files were handed over, and are gone. */
  take(): CoreEvent[] {
    const left = this.isAtOwnWork ? this.batches : this.batches.slice(1);
    this.batches = [];
    this.isAtOwnWork = false;
    return left.flatMap(({ events }) => events.filter(({ type }) => type !== "file"));
  }
}
