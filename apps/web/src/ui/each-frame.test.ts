// SPDX-License-Identifier: Apache-2.0
import { beforeEach, describe, expect, it } from "vitest";
import { eachFrame, type EachFrame } from "./each-frame";

describe("values of one frame", () => {
  let asked: (() => void)[] = [];
  let taken: number[] = [];
  let values: EachFrame<number>;

  beforeEach(() => {
    asked = [];
    taken = [];
    values = eachFrame<number>(
      (value) => taken.push(value),
      (run) => asked.push(run),
    );
  });

  it("are handed over as one: the newest", () => {
    values.put(1);
    values.put(2);
    expect(asked.length).toBe(1);
    asked[0]?.();
    expect(taken).toEqual([2]);
  });

  it("are handed over at once when the hand lifts, and not again", () => {
    values.put(3);
    values.flush();
    asked[0]?.();
    expect(taken).toEqual([3]);
  });

  it("come again with the next frame", () => {
    values.put(1);
    asked[0]?.();
    values.put(2);
    asked[1]?.();
    expect(taken).toEqual([1, 2]);
  });
});
