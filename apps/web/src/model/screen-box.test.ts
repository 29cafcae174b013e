// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { extentOf } from "./extent";
import { clipMatrix } from "./placement";
import { screenBox } from "./screen-box";

const picture = { width: 1000, height: 800 };
const extent = extentOf(Float32Array.of(-50, -20, -10, 50, 20, 10));

const boxAt = (x: number, y: number) =>
  screenBox(clipMatrix([1, 0, 0, x, 0, -1, 0, y, 0, 0, 1, 0], extent, picture), extent, picture, 3);

describe("the box of a model on the picture", () => {
  it("holds all of it, from below", () => {
    const box = boxAt(500, 300);
    expect(box.x).toBeLessThanOrEqual(450 - 3);
    expect(box.x + box.width).toBeGreaterThanOrEqual(550 + 3);
    expect(box.y).toBeLessThanOrEqual(800 - 320 - 3);
    expect(box.y + box.height).toBeGreaterThanOrEqual(800 - 280 + 3);
  });

  it("is not much larger", () => {
    expect(boxAt(500, 300).width).toBeLessThan(130);
    expect(boxAt(500, 300).height).toBeLessThan(60);
  });

  it("ends with the picture", () => {
    expect(boxAt(0, 800)).toMatchObject({ x: 0, y: 0 });
    expect(boxAt(2000, 300).width).toBe(0);
  });
});
