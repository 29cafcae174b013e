// SPDX-License-Identifier: Apache-2.0
import { signal, type ReadonlySignal } from "@preact/signals";
import type { Notice } from "./studio";

/** More would cover the drawing; the oldest go. */
const most = 4;

/** What is being said to the person. */
export class NoticeBoard {
  private readonly board = signal<readonly Notice[]>([]);
  private lastId = 0;

  get notices(): ReadonlySignal<readonly Notice[]> {
    return this.board;
  }

  /** The same words again take the place of those before. */
  add(notice: Omit<Notice, "id">): void {
    const others = this.board.value.filter((each) => each.text !== notice.text);
    this.board.value = [...others, { ...notice, id: ++this.lastId }].slice(-most);
  }

  dismiss(id: number): void {
    this.board.value = this.board.value.filter((notice) => notice.id !== id);
  }
}
