// SPDX-License-Identifier: Apache-2.0
import { expect, test } from "vitest";
import { Replies } from "./replies";

test("an answer goes to all who wait for its number or one before, and to no other", async () => {
  const replies = new Replies<string>();
  const early = replies.wait(3);
  const late = replies.wait(5);
  expect(replies.resolve(2, "too early")).toBe(false);
  expect(replies.resolve(4, "first")).toBe(true);
  expect(replies.resolve(5, "second")).toBe(true);
  expect(await Promise.all([early, late])).toEqual(["first", "second"]);
});

test("who waits for a core that is gone is told so", async () => {
  const replies = new Replies<string>();
  const answer = replies.wait(1);
  replies.failAll("restarted");
  await expect(answer).rejects.toThrow("restarted");
  expect(replies.resolve(1, "nobody")).toBe(false);
});
