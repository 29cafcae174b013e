// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { bytesOf } from "./store-in-test";
import { checkSum } from "./check-sum";

describe("the check sum", () => {
  it("is the CRC-32 of zip and PNG", () => {
    expect(checkSum("", bytesOf("123456789"))).toBe(0xcbf43926);
    expect(checkSum("1234", bytesOf("56789"))).toBe(0xcbf43926);
    expect(checkSum("", bytesOf(""))).toBe(0);
  });

  it("changes with every bit", () => {
    const bytes = bytesOf("some line of a journal");
    const sum = checkSum("place", bytes);
    for (let bit = 0; bit < 8 * bytes.length; ++bit) {
      const flipped = bytes.map((byte, at) => (at === bit >> 3 ? byte ^ (1 << (bit & 7)) : byte));
      expect(checkSum("place", flipped)).not.toBe(sum);
    }
  });
});
