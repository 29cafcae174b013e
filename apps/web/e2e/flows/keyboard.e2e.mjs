// SPDX-License-Identifier: Apache-2.0
// Everything but the free line, without a mouse.
import assert from "node:assert/strict";
import { assertValidGlb } from "../harness/judges.mjs";
import { countDifferent, readPng } from "../harness/png.mjs";
import { test } from "../harness/tests.mjs";

/** Presses Tab until what has the focus is called so. */
async function tabTo({ page, keys }, name, most = 60) {
  const seen = [];
  for (let count = 0; count < most; ++count) {
    await keys.press("Tab");
    const label = await page.evaluate(() => {
      const element = document.activeElement;
      return element?.getAttribute("aria-label") ?? element?.textContent?.trim() ?? "";
    });
    if (name.test(label)) return label;
    seen.push(label);
  }
  return assert.fail(`Tab never comes to ${name}: ${seen.join(" | ")}`);
}

test("an example is opened, changed, inflated, turned and exported by keys", {}, async (world) => {
  const { studio, page, keys, picture } = world;
  await studio.open();
  await tabTo(world, /example|mug|dog|robot|snail|dragon/i);
  await picture("focus");
  await keys.press("Enter");
  const opened = await studio.until("parts", (state) => !state.isBlank);
  if (opened.hasRoughStrokes) await keys.press("Enter");
  const drawn = await studio.until("parts", (state) => state.layers.length > 0);

  await tabTo(world, new RegExp(drawn.layers[0].name, "i"));
  await keys.press("Enter");
  await studio.until("a selection", (state) => state.layers.some((layer) => layer.isSelected));
  await picture("selected");
  await studio.act("cancel");

  await keys.press("2");
  await studio.until("the model", (state) => state.mode === "inflate");
  await page.waitForTimeout(900);
  const front = readPng(await picture("front"));
  for (let count = 0; count < 8; ++count) await keys.press("ArrowRight");
  await page.waitForTimeout(300);
  assert.ok(countDifferent(front, readPng(await picture("turned"))) > 1000, "it has not turned");

  await keys.press("Control+Shift+e");
  await page.getByRole("dialog").waitFor();
  await tabTo(world, /GLB/);
  const file = await studio.download(() => keys.press("Enter"));
  await assertValidGlb(file.bytes);
});
