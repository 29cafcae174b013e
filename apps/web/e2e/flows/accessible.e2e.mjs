// SPDX-License-Identifier: Apache-2.0
// axe-core finds nothing, wherever one can be: each mode and panel, light and dark, wide and narrow.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { characterOn, drawPart, inflate } from "../harness/drawn.mjs";
import { test } from "../harness/tests.mjs";

const axeSource = await readFile(createRequire(import.meta.url).resolve("axe-core"), "utf8");
const tags = ["wcag2a", "wcag2aa", "wcag21aa", "wcag22aa", "best-practice"];
const panels = ["menu", "help", "export", "palette", "gallery", "settings", "sessions", "parts"];

async function findings(page) {
  await page.evaluate(axeSource);
  return page.evaluate(async (wanted) => {
    const { violations } = await globalThis.axe.run({ runOnly: wanted });
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" ")}`);
  }, tags);
}

async function assertAccessible({ page, picture }, where) {
  await page.waitForTimeout(350);
  await picture(where);
  const found = await findings(page);
  assert.deepEqual(found, [], `${where}: ${found.join("\n")}`);
}

async function tryPanels(world) {
  for (const panel of panels) {
    await world.page.evaluate((name) => (globalThis.inkflateStudio.panel.value = name), panel);
    await assertAccessible(world, panel);
  }
  await world.page.evaluate(() => (globalThis.inkflateStudio.panel.value = null));
}

for (const device of ["wide", "phone"]) {
  for (const colorScheme of ["light", "dark"]) {
    const options = { device, context: { colorScheme }, timeoutS: 120 };
    test(`axe finds nothing: ${device}, ${colorScheme}`, options, async (world) => {
      const { studio, mouse } = world;
      await studio.open();
      await assertAccessible(world, "empty");
      const { body } = await characterOn(studio);
      await mouse.strokes(body);
      await assertAccessible(world, "rough");
      await drawPart(world, mouse, body.slice(0, 1), 1);
      await assertAccessible(world, "drawn");
      await studio.act("select_all");
      await assertAccessible(world, "selected");
      await tryPanels(world);
      await inflate(world);
      await assertAccessible(world, "inflated");
    });
  }
}
