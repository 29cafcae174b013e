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
  const example = page
    .getByRole("list", { name: /example/i })
    .getByRole("button")
    .first();
  const name = await example.textContent();
  await tabTo(world, new RegExp(name));
  await picture("focus");
  await keys.press("Enter");
  const opened = await studio.until("an example", (state) => !state.isBlank);
  if (opened.hasRoughStrokes) await keys.press("Enter");
  await studio.until("parts", (state) => state.layers.length > 1);

  await keys.press("Control+a");
  await studio.until("all", (state) => state.layers.every((layer) => layer.isSelected));
  await keys.press("Escape");
  const drawn = await studio.until("none", (state) => !state.layers.some((l) => l.isSelected));
  await tabTo(world, new RegExp(drawn.layers[0].name, "i"));
  await keys.press("Enter");
  await studio.until("one part", (state) => state.layers[0].isSelected);
  await picture("selected");
  await keys.press("PageDown");
  const ids = (state) => state.layers.map((layer) => layer.id).join();
  const reordered = await studio.until("another order", (state) => ids(state) !== ids(drawn));
  assert.notEqual(reordered.layers[0].id, drawn.layers[0].id);

  await keys.press("2");
  await studio.until("the model", (state) => state.mode === "inflate" && !state.isWorking);
  await page.waitForTimeout(900);
  const front = readPng(await picture("front"));
  for (let count = 0; count < 8; ++count) await keys.press("ArrowRight");
  await studio.atRest();
  assert.ok(countDifferent(front, readPng(await picture("turned"))) > 1000, "it has not turned");

  await keys.press("Control+Shift+e");
  const dialog = page.getByRole("dialog", { name: "Export" });
  await dialog.getByRole("button", { name: "Save", disabled: false }).waitFor();
  await picture("export");
  await tabTo(world, /^Save$/);
  const file = await studio.download(() => keys.press("Enter"));
  await assertValidGlb(file.bytes);
});
