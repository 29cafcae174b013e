// SPDX-License-Identifier: Apache-2.0
// The end comes at any moment: of the tab, of the browser.
import assert from "node:assert/strict";
import { seededRandom } from "../harness/random.mjs";
import { StudioPage } from "../harness/studio-page.mjs";
import { test } from "../harness/tests.mjs";
import { assertKept, drawForever, pause, strokesIn, times, watchDrawing } from "./drawing.mjs";
import { OwnBrowser } from "./own-browser.mjs";

const longestDrawingMs = 2500;
const crashes = times(5, 50);

/** Runs in the page: waits until the browser has taken back what the tab that died has held. A person takes longer. */
async function untilLocksAreFree() {
  while ((await globalThis.navigator.locks.query()).held.length > 0) {
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
}

async function crash(page) {
  const { origin } = new URL(page.url());
  const context = page.context();
  const cdp = await context.newCDPSession(page);
  const end = page.waitForEvent("crash");
  cdp.send("Page.crash").catch(() => null);
  await end;
  await page.close();
  const witness = await context.newPage();
  await witness.goto(`${origin}/manifest.webmanifest`);
  await witness.evaluate(untilLocksAreFree);
  await witness.close();
}

/**
 * Draws, comes to an end and starts again, as often as is wanted; each time the drawing goes on from all that was there.
 *
 * @param {(count: number) => Promise<object>} open gives a page with the studio
 * @param {(page: object) => Promise<void>} end
 */
async function drawToTheEnd(open, end) {
  const random = seededRandom(7);
  let last = null;
  let most = 0;
  for (let count = 0; count <= crashes; ++count) {
    const page = await open(count);
    const found = await strokesIn(page);
    if (last !== null) assertKept({ ...last, found, what: `end ${count}` });
    const told = watchDrawing(page);
    drawForever(page, 100 + count);
    await pause(random() * longestDrawingMs);
    last = { before: found, told, endMs: Date.now() };
    await end(page);
    if (count % 10 === 9) console.log(`  ${count + 1} ends, ${found} strokes`);
    most = Math.max(most, found);
  }
  assert.ok(most > 0, "nothing was drawn");
}

test(
  `${crashes} crashes of the tab cost nothing that was finished`,
  { timeoutS: 60 + 20 * crashes },
  async ({ context, page: first, origin }) => {
    const open = async (count) => {
      const page = count === 0 ? first : await context.newPage();
      await new StudioPage(page, origin).open();
      return page;
    };
    await drawToTheEnd(open, crash);
  },
);

test(
  `${crashes} kills of the browser cost nothing that was finished`,
  { timeoutS: 60 + 30 * crashes },
  async ({ origin }) => {
    const folder = await OwnBrowser.folder();
    let browser = null;
    const open = async () => {
      browser = await OwnBrowser.start(folder);
      return (await browser.studio(origin)).page;
    };
    try {
      await drawToTheEnd(open, () => browser.kill());
    } finally {
      await browser?.kill();
      await folder.remove();
    }
  },
);
