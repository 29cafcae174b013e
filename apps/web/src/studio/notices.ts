// SPDX-License-Identifier: Apache-2.0
import { signal, type ReadonlySignal } from "@preact/signals";
import type { Notice } from "./studio";

/** More would cover the drawing; the oldest go. */
const most = 4;

/** Nothing went wrong, and nothing can be done about it. */
function isOnlyTold({ severity, place, remedy }: Notice): boolean {
  return severity === "status" && place === null && remedy === null;
}

/** What is being said to the person. */
export class NoticeBoard {
  private readonly board = signal<readonly Notice[]>([]);
  private lastId = 0;

  get notices(): ReadonlySignal<readonly Notice[]> {
    return this.board;
  }

  /** What has only been told gives way to what is said next, and so do the same words. */
  add(notice: Omit<Notice, "id">): void {
    const others = this.board.value.filter(
      (each) => each.text !== notice.text && !isOnlyTold(each),
    );
    this.board.value = [...others, { ...notice, id: ++this.lastId }].slice(-most);
  }

  dismiss(id: number): void {
    this.board.value = this.board.value.filter((notice) => notice.id !== id);
  }
}
