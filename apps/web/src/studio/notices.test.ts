// SPDX-License-Identifier: Apache-2.0
import { expect, test } from "vitest";
import { NoticeBoard } from "./notices";

const say = (board: NoticeBoard, text: string) => {
  board.add({ severity: "warning", text, place: null, remedy: null });
};
const texts = (board: NoticeBoard) => board.notices.value.map((notice) => notice.text);

test("the same words are not shown twice, and come last", () => {
  const board = new NoticeBoard();
  ["a", "b", "a"].forEach((text) => {
    say(board, text);
  });
  expect(texts(board)).toEqual(["b", "a"]);
});

test("the oldest go when there are too many to read", () => {
  const board = new NoticeBoard();
  ["a", "b", "c", "d", "e"].forEach((text) => {
    say(board, text);
  });
  expect(texts(board)).toEqual(["b", "c", "d", "e"]);
});

test("a notice that was put away is gone", () => {
  const board = new NoticeBoard();
  say(board, "a");
  say(board, "b");
  board.dismiss(board.notices.value[0]!.id);
  expect(texts(board)).toEqual(["b"]);
});

test("what has only been told gives way to what is said next", () => {
  const board = new NoticeBoard();
  const told = { severity: "status", place: null, remedy: null } as const;
  const remedy = { label: "undo it", run: () => undefined };
  board.add({ ...told, text: "a" });
  board.add({ ...told, text: "b", remedy });
  board.add({ ...told, text: "c" });
  say(board, "d");
  expect(texts(board)).toEqual(["b", "d"]);
});
