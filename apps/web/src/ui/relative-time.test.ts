// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { relativeTime } from "./relative-time";

const minuteMs = 60_000;
const dayMs = 24 * 60 * minuteMs;
const nowMs = 1000 * dayMs;

describe("how long ago it was", () => {
  it.each([
    [0, "now"],
    [59_999, "now"],
    [-5 * dayMs, "now"],
    [minuteMs, "1 minute ago"],
    [59.9 * minuteMs, "59 minutes ago"],
    [60 * minuteMs, "1 hour ago"],
    [23.9 * 60 * minuteMs, "23 hours ago"],
    [dayMs, "yesterday"],
    [6 * dayMs, "6 days ago"],
    [7 * dayMs, "last week"],
    [29 * dayMs, "4 weeks ago"],
    [45 * dayMs, "last month"],
    [800 * dayMs, "2 years ago"],
  ])("is told in the largest unit that is full (%i ms)", (agoMs, text) => {
    expect(relativeTime(nowMs - agoMs, nowMs, "en")).toBe(text);
  });

  it("is told in the person's language", () => {
    expect(relativeTime(nowMs - 5 * minuteMs, nowMs, "cs")).toBe("před 5 minutami");
  });
});
