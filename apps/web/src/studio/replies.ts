// SPDX-License-Identifier: Apache-2.0

interface Waiting<T> {
  readonly sequence: number;
  readonly resolve: (value: T) => void;
  readonly reject: (why: Error) => void;
}

/** Promises for answers that come out of a stream of numbered frames. */
export class Replies<T> {
  private waiting: Waiting<T>[] = [];

  /** The answer to the event of this number. */
  wait(sequence: number): Promise<T> {
    return new Promise((resolve, reject) => {
      this.waiting.push({ sequence, resolve, reject });
    });
  }

  /** An answer to all events up to a number has come. Returns whether somebody has waited for it. */
  resolve(sequence: number, value: T): boolean {
    const due = this.waiting.filter((each) => each.sequence <= sequence);
    this.waiting = this.waiting.filter((each) => each.sequence > sequence);
    for (const each of due) each.resolve(value);
    return due.length > 0;
  }

  resolveAll(value: T): void {
    this.resolve(Number.POSITIVE_INFINITY, value);
  }

  failAll(why: string): void {
    const all = this.waiting;
    this.waiting = [];
    for (const each of all) each.reject(new Error(why));
  }
}
