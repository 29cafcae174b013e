// SPDX-License-Identifier: Apache-2.0
import { expect, test } from "vitest";
import { Replies } from "./replies";

test("an answer goes to all whose key it answers, and to no other", async () => {
  const replies = new Replies<number, string>();
  const upTo = (number: number) => (key: number) => key <= number;
  const early = replies.wait(3);
  const late = replies.wait(5);
  expect(replies.resolve(upTo(2), "too early")).toBe(false);
  expect(replies.resolve(upTo(4), "first")).toBe(true);
  expect(replies.resolve(upTo(5), "second")).toBe(true);
  expect(await Promise.all([early, late])).toEqual(["first", "second"]);
});

test("who waits for a core that is gone is told so", async () => {
  const replies = new Replies<number, string>();
  const answer = replies.wait(1);
  replies.failAll("restarted");
  await expect(answer).rejects.toThrow("restarted");
  expect(replies.resolve(() => true, "nobody")).toBe(false);
});
