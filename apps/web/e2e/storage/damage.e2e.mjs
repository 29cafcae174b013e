// SPDX-License-Identifier: Apache-2.0
// Whatever has become of the stored bytes, the studio starts, and can be drawn in.
import assert from "node:assert/strict";
import { readdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { seededRandom } from "../harness/random.mjs";
import { test } from "../harness/tests.mjs";
import { drawSome, openAgain, strokesIn, times } from "./drawing.mjs";
import { OwnBrowser } from "./own-browser.mjs";

const flips = times(20, 1000);
const starts = times(2, 50);

const sittings = [4, 5, 6];
const strokesBefore = (sitting) =>
  sittings.slice(0, sitting).reduce((sum, count) => sum + count, 0);

/** Runs in the page: keeps aside all that is stored. */
async function keepAll() {
  const request = indexedDB.open("inkflate");
  await new Promise((resolve) => (request.onsuccess = resolve));
  const names = [...request.result.objectStoreNames];
  const reading = request.result.transaction(names);
  const result = (asked) =>
    new Promise((resolve) => (asked.onsuccess = () => resolve(asked.result)));
  globalThis.keptRecords = [];
  for (const name of names) {
    const table = reading.objectStore(name);
    const [keys, values] = await Promise.all([result(table.getAllKeys()), result(table.getAll())]);
    keys.forEach((key, at) => globalThis.keptRecords.push({ name, key, value: values[at] }));
  }
  request.result.close();
  return globalThis.keptRecords.length;
}

/** Runs in the page: stores what was kept aside, with one byte of it changed. @returns {string} which */
async function storeDamaged([which, where, change]) {
  const records = globalThis.structuredClone(globalThis.keptRecords);
  const { name, key, value } = records[Math.floor(which * records.length)];
  const members = Object.keys(value);
  const member = members[Math.floor(where * members.length)];
  const by = 1 + Math.floor(change * 255);
  if (value[member] instanceof Uint8Array) {
    const at = Math.floor(((where * members.length) % 1) * value[member].length);
    value[member][at] ^= by;
  } else if (typeof value[member] === "string") {
    value[member] = String.fromCharCode(by) + value[member].slice(1);
  } else if (typeof value[member] === "number") {
    value[member] += by * 256 ** Math.floor(change * 4);
  }
  const request = indexedDB.open("inkflate");
  await new Promise((resolve) => (request.onsuccess = resolve));
  const names = [...request.result.objectStoreNames];
  const writing = request.result.transaction(names, "readwrite");
  for (const each of names) writing.objectStore(each).clear();
  for (const each of records) writing.objectStore(each.name).put(each.value, each.key);
  await new Promise((resolve) => (writing.oncomplete = resolve));
  request.result.close();
  return `${name} ${key} ${member}`;
}

const openSession = (session) => globalThis.inkflateStudio.openSession(session);
const ownSession = () => globalThis.sessionStorage.getItem("inkflate.session");

test(
  `the studio goes on after each of ${flips} damaged bytes`,
  { timeoutS: 90 + 6 * flips },
  async ({ studio, page }) => {
    await studio.open();
    for (const [sitting, count] of sittings.entries()) {
      await openAgain(studio);
      await drawSome(page, 1 + sitting, count);
      await studio.saved();
    }
    const session = await page.evaluate(ownSession);
    await page.evaluate(openSession, null);
    await studio.until("another drawing", (state) => !state.isStarting && state.isBlank);
    assert.ok((await page.evaluate(keepAll)) > 5);

    const random = seededRandom(5);
    for (let count = 0; count < flips; ++count) {
      const what = await page.evaluate(storeDamaged, [random(), random(), random()]);
      await page.evaluate(openSession, session);
      await studio.until(`open with ${what}`, (state) => !state.isStarting);
      // One damaged byte never costs more than was drawn since the last start.
      const found = await strokesIn(page);
      assert.ok(found >= strokesBefore(2) && found <= strokesBefore(3), `${what}: ${found}`);
      await studio.saved();
      await page.evaluate(openSession, null);
      await studio.until("another drawing", (state) => !state.isStarting && state.isBlank);
    }
  },
);

/** Overwrites a few bytes in one of the files that the browser keeps IndexedDB in. */
async function damageFile(folder, random) {
  const all = await readdir(folder.path, { recursive: true, withFileTypes: true });
  const isOurs = (path) => path.includes("indexeddb.leveldb") || path.includes("indexeddb.blob");
  const paths = all
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
    .filter(isOurs);
  const path = paths[Math.floor(random() * paths.length)];
  const bytes = await readFile(path);
  const start = Math.floor(random() * bytes.length);
  for (let at = start; at < Math.min(bytes.length, start + 16); ++at) bytes[at] ^= 0x5a;
  await writeFile(path, bytes);
  return path;
}

test(
  `the studio starts after each of ${starts} damaged files of the browser`,
  { timeoutS: 90 + 30 * starts },
  async ({ origin }) => {
    const random = seededRandom(6);
    const folder = await OwnBrowser.folder();
    let browser = null;
    try {
      for (let count = 0; count <= starts; ++count) {
        if (count > 0) await damageFile(folder, random);
        browser = await OwnBrowser.start(folder);
        const studio = await browser.studio(origin);
        const before = await strokesIn(studio.page);
        await drawSome(studio.page, 1 + count, 3);
        assert.equal(await strokesIn(studio.page), before + 3);
        await browser.kill();
      }
    } finally {
      await browser?.kill();
      await folder.remove();
    }
  },
);
