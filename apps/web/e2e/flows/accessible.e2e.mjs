// SPDX-License-Identifier: Apache-2.0
// axe-core finds nothing, wherever one can be: each mode and panel, light and dark, wide and narrow.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { characterOn, inflate } from "../harness/drawn.mjs";
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

/** All that is found is told at once. */
class Inspection {
  found = [];

  constructor(world) {
    this.world = world;
  }

  async look(where) {
    const { page, picture } = this.world;
    await page.waitForTimeout(350);
    await picture(where);
    for (const finding of await findings(page)) this.found.push(`${where}: ${finding}`);
  }

  async lookAtPanels() {
    const { page } = this.world;
    const show = (panel) =>
      page.evaluate((name) => {
        globalThis.inkflateStudio.panel.value = name;
      }, panel);
    for (const panel of panels) {
      await show(panel);
      await this.look(panel);
    }
    await show(null);
  }
}

for (const device of ["wide", "phone"]) {
  for (const colorScheme of ["light", "dark"]) {
    const options = { device, context: { colorScheme }, timeoutS: 300 };
    test(`axe finds nothing: ${device}, ${colorScheme}`, options, async (world) => {
      const { studio, mouse } = world;
      const inspection = new Inspection(world);
      await studio.open();
      await inspection.look("empty");
      const { body } = await characterOn(studio);
      await mouse.strokes(body);
      await inspection.look("rough");
      await studio.act("simplify");
      await studio.partsAre(1);
      await studio.act("select_all");
      await inspection.look("selected");
      await inspection.lookAtPanels();
      await studio.act("deform");
      await studio.act("add_pin");
      await studio.until("a pin", (state) => state.hasPin);
      await inspection.look("bending");
      await world.page.getByRole("button", { name: "More about bending" }).click();
      await inspection.look("more about bending");
      await inflate(world);
      await inspection.look("inflated");
      assert.deepEqual(inspection.found, []);
    });
  }
}
