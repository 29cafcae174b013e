// SPDX-License-Identifier: Apache-2.0

interface Waiting<Key, T> {
  readonly key: Key;
  readonly resolve: (value: T) => void;
  readonly reject: (why: Error) => void;
}

/** Promises for answers that come as messages; the key tells which answer is whose. */
export class Replies<Key, T> {
  private waiting: Waiting<Key, T>[] = [];

  wait(key: Key): Promise<T> {
    return new Promise((resolve, reject) => {
      this.waiting.push({ key, resolve, reject });
    });
  }

  /** An answer has come. Returns whether somebody has waited for it. */
  resolve(isAnswered: (key: Key) => boolean, value: T): boolean {
    const due = this.waiting.filter((each) => isAnswered(each.key));
    this.waiting = this.waiting.filter((each) => !isAnswered(each.key));
    for (const each of due) each.resolve(value);
    return due.length > 0;
  }

  failAll(why: string): void {
    const all = this.waiting;
    this.waiting = [];
    for (const each of all) each.reject(new Error(why));
  }
}
