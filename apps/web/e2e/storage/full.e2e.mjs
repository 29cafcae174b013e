// SPDX-License-Identifier: Apache-2.0
// A device without room, and a browser that lets nothing be stored: it is told, and the drawing goes on.
import assert from "node:assert/strict";
import { test } from "../harness/tests.mjs";
import { drawSome, openAgain, strokesIn } from "./drawing.mjs";

const quotaBytes = 5e6;
const warningMs = 1000;

/** Runs in the page: fills what the browser gives us with something else, down to the last kilobyte. */
async function fillUp() {
  const request = indexedDB.open("filler", 1);
  request.onupgradeneeded = () =>
    request.result.createObjectStore("bytes", { autoIncrement: true });
  await new Promise((resolve) => (request.onsuccess = resolve));
  const put = (size) =>
    new Promise((resolve) => {
      const writing = request.result.transaction("bytes", "readwrite", { durability: "strict" });
      writing.objectStore("bytes").put(globalThis.crypto.getRandomValues(new Uint8Array(size)));
      writing.oncomplete = () => resolve(true);
      writing.onabort = () => resolve(false);
    });
  let count = 0;
  for (const size of [65536, 16384, 4096, 1024, 256]) {
    while (await put(size)) ++count;
  }
  request.result.close();
  return count;
}

function emptyAgain() {
  return new Promise((resolve) => {
    indexedDB.deleteDatabase("filler").onsuccess = () => resolve();
  });
}

/** The words about the save that a person can see, and how long it took until these were there. */
async function assertTold(page, words) {
  const start = Date.now();
  await page.getByText(words).first().waitFor({ state: "visible" });
  return Date.now() - start;
}

async function assertDownloads({ studio }) {
  const { name, bytes } = await studio.download(() =>
    studio.page.evaluate(() => {
      delete globalThis.showSaveFilePicker;
      globalThis.inkflateStudio.act("save");
    }),
  );
  assert.match(name, /\.inkflate$/);
  assert.equal(bytes.toString("latin1", 0, 2), "PK");
}

test(
  "a full device is told within a second, and all is written when there is room",
  {},
  async (world) => {
    const { studio, page, cdp, origin } = world;
    await studio.open();
    await cdp.send("Storage.overrideQuotaForOrigin", { origin, quotaSize: quotaBytes });
    await drawSome(page, 3, 3);
    assert.ok((await page.evaluate(fillUp)) > 4);

    await drawSome(page, 4, 5);
    const waitedMs = await assertTold(page, /Not saved: this device is full/);
    assert.ok(waitedMs < warningMs, `told after ${waitedMs} ms`);
    assert.deepEqual((await studio.state()).saveState, { kind: "refused", why: "full" });
    assert.equal(await strokesIn(page), 8);
    await assertDownloads(world);

    await page.evaluate(emptyAgain);
    await drawSome(page, 5, 2);
    await studio.saved();
    await openAgain(studio);
    assert.equal(await strokesIn(page), 10);
  },
);

const refusals = {
  "is missing": "Object.defineProperty(self, 'indexedDB', { value: undefined });",
  throws: "Object.defineProperty(self, 'indexedDB', { get() { throw new Error('refused'); } });",
  "opens nothing": "indexedDB.open = () => { throw new DOMException('', 'SecurityError'); };",
};

/** The scripts of our workers begin with these words. */
async function beginWorkersWith(context, words) {
  await context.route("**/*.js", async (route) => {
    const answer = await route.fetch();
    const text = await answer.text();
    const isPage = text.includes("document.getElementById");
    await route.fulfill({ response: answer, body: isPage ? text : words + text });
  });
}

for (const [how, words] of Object.entries(refusals)) {
  const options = { context: { serviceWorkers: "block" } };
  test(`the studio draws and downloads where IndexedDB ${how}`, options, async (world) => {
    const { studio, page, context } = world;
    await beginWorkersWith(context, words);
    await studio.open();
    await drawSome(page, 6, 4);
    const waitedMs = await assertTold(page, /Not saved: this browser allows no storage/);
    assert.ok(waitedMs < warningMs, `told after ${waitedMs} ms`);
    assert.equal(await strokesIn(page), 4);
    await assertDownloads(world);
  });
}
