// SPDX-License-Identifier: Apache-2.0
// Several tabs at once, and drawings from before.
import assert from "node:assert/strict";
import { StudioPage } from "../harness/studio-page.mjs";
import { test } from "../harness/tests.mjs";
import { drawSome, openAgain, strokesIn } from "./drawing.mjs";

async function opened(page, origin) {
  const studio = new StudioPage(page, origin);
  await studio.open();
  return studio;
}

test("two tabs at once do not harm each other", {}, async ({ context, page, origin }) => {
  const one = await opened(page, origin);
  await drawSome(page, 1, 3);
  const other = await opened(await context.newPage(), origin);
  assert.equal(await strokesIn(other.page), 0);
  await Promise.all([drawSome(page, 2, 6), drawSome(other.page, 3, 8)]);
  await one.saved();
  await other.saved();
  for (const studio of [one, other]) await openAgain(studio);
  assert.equal(await strokesIn(page), 9);
  assert.equal(await strokesIn(other.page), 8);
});

test("a tab that is doubled begins a drawing of its own", {}, async ({ context, page, origin }) => {
  const one = await opened(page, origin);
  await drawSome(page, 1, 3);
  await one.saved();
  // What window.open opens knows what its opener has kept for itself.
  const doubling = context.waitForEvent("page");
  await page.evaluate(() => globalThis.open(globalThis.location.href).focus());
  const double = new StudioPage(await doubling, origin);
  await double.until("ready", (state) => !state.isStarting);
  assert.equal(await strokesIn(double.page), 0);
  await drawSome(double.page, 2, 2);
  await double.saved();
  await openAgain(one);
  assert.equal(await strokesIn(page), 3);
});

test(
  "the tab that is opened again has the drawing, unasked",
  {},
  async ({ context, page, origin }) => {
    const one = await opened(page, origin);
    await drawSome(page, 1, 3);
    await one.saved();
    await page.close();
    const again = await opened(await context.newPage(), origin);
    assert.equal(await strokesIn(again.page), 3);
    assert.equal((await again.state()).panel, null);
  },
);
