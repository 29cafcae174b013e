// SPDX-License-Identifier: Apache-2.0
// A drawing that is fitted into the window lies free of what floats at its edges.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { devices } from "../harness/devices.mjs";
import { topFolder } from "../harness/folders.mjs";
import { readPng } from "../harness/png.mjs";
import { test } from "../harness/tests.mjs";

const pieces = ".top-bar > *, .tool-bar, .parts-dock, .context-settings, .context-next";
const darkest = 110;

function boxesOf(page) {
  return page.locator(pieces).evaluateAll((all) =>
    all.map((each) => {
      const { left, top, right, bottom } = each.getBoundingClientRect();
      return { name: each.className, left, top, right, bottom };
    }),
  );
}

/** Which of the boxes there is ink in. */
function inked(picture, boxes) {
  const hasInk = ({ left, top, right, bottom }) => {
    for (let y = Math.ceil(top); y < Math.min(bottom, picture.height); ++y) {
      for (let x = Math.ceil(left); x < Math.min(right, picture.width); ++x) {
        if (picture.at(x, y).every((value) => value < darkest)) return true;
      }
    }
    return false;
  };
  return boxes.filter(hasInk).map(({ name }) => name);
}

/** A wide and a high drawing. */
const dog = () => readFile(join(topFolder, "examples/characters/dog.svg"));
const upright = () =>
  Buffer.from(
    `<svg xmlns="http://www.w3.org/2000/svg" width="400" height="1600" fill="none" stroke="#000" stroke-width="4">
    <path d="M 10 10 L 390 10 L 390 1590 L 10 1590 Z"/></svg>`,
  );

for (const device of Object.keys(devices)) {
  test(
    `${device}: what is opened lies beside the bars, not under them`,
    { device },
    async (world) => {
      const { studio, page, picture } = world;
      await studio.open();
      for (const [name, bytes] of [
        ["dog", await dog()],
        ["upright", upright()],
      ]) {
        await studio.openFile(`${name}.svg`, bytes);
        await studio.until(name, (state) => state.fileName === name);
        await studio.atRest();
        await picture(name);
        const boxes = await boxesOf(page);
        const show = (display) =>
          page.evaluate((value) => {
            for (const each of document.querySelectorAll(".chrome, .hint, .notices")) {
              each.style.display = value;
            }
          }, display);
        await show("none");
        const drawn = readPng(await page.screenshot());
        await show("");
        assert.deepEqual(inked(drawn, boxes), [], name);
        const window = { name: "ink", left: 0, top: 0, right: drawn.width, bottom: drawn.height };
        assert.deepEqual(inked(drawn, [window]), ["ink"], name);
      }
    },
  );
}
