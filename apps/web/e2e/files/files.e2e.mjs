// SPDX-License-Identifier: Apache-2.0
// Files that come to the studio and leave it, and the studio's own files when there is a new version of them.
import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { studioFolder, topFolder } from "../harness/folders.mjs";
import { servePlainly } from "../harness/static-server.mjs";
import { test } from "../harness/tests.mjs";

const drawing = () => readFile(join(topFolder, "examples/sketches/goose.svg"));
const picture = () => readFile(join(topFolder, "apps/web/public/icons/icon-192.png"));

/** As the system drops a file on the page. */
async function drop(page, name, type, bytes) {
  const transfer = await page.evaluateHandle(
    ([fileName, fileType, base64]) => {
      const data = Uint8Array.from(atob(base64), (sign) => sign.charCodeAt(0));
      const made = new globalThis.DataTransfer();
      made.items.add(new File([data], fileName, { type: fileType }));
      return made;
    },
    [name, type, Buffer.from(bytes).toString("base64")],
  );
  for (const event of ["dragenter", "dragover", "drop"]) {
    await page.dispatchEvent("body", event, { dataTransfer: transfer });
  }
}

test("a drawing dropped on an empty sheet is opened, a second one is added", {}, async (world) => {
  const { studio, page } = world;
  await studio.open();
  await drop(page, "goose.svg", "image/svg+xml", await drawing());
  const opened = await studio.until("opened", (state) => !state.isBlank);
  assert.equal(opened.fileName, "goose");
  await drop(page, "other.svg", "image/svg+xml", await drawing());
  const offer = page.getByRole("button", { name: "Open it instead" });
  // With the focus in it, a notice waits.
  await offer.focus();
  await offer.click();
  await studio.until("opened instead", (state) => state.fileName === "other");
});

test("a drawing is called what it was called when the page is loaded again", {}, async (world) => {
  const { studio, page } = world;
  await studio.open();
  await drop(page, "goose.svg", "image/svg+xml", await drawing());
  await studio.until("opened", (state) => !state.isBlank);
  await studio.saved();
  for (const time of ["once", "twice"]) {
    await page.reload();
    const again = await studio.until(time, (state) => state !== null && !state.isBlank);
    assert.equal(again.fileName, "goose", time);
    await studio.atRest();
  }
  const { name } = await studio.download(() => studio.act("save"));
  assert.equal(name, "goose.inkflate");
});

test("a picture dropped beside a drawing is one to trace", {}, async (world) => {
  const { studio, page, keys } = world;
  await studio.open();
  await drop(page, "goose.svg", "image/svg+xml", await drawing());
  await studio.until("opened", (state) => !state.isBlank);
  await drop(page, "scan.png", "image/png", await picture());
  await studio.until("a reference picture", (state) => state.hasTemplate);
  await keys.press("Control+z");
  await studio.until("taken back", (state) => !state.hasTemplate && !state.isBlank);
});

test("a text of SVG can be pasted", {}, async (world) => {
  const { studio, page } = world;
  await studio.open();
  await page.evaluate(
    (text) => {
      const data = new globalThis.DataTransfer();
      data.setData("text/plain", text);
      const options = { clipboardData: data, bubbles: true, cancelable: true };
      document.body.dispatchEvent(new globalThis.ClipboardEvent("paste", options));
    },
    String(await drawing()),
  );
  await studio.until("pasted", (state) => !state.isBlank);
});

test("what is no drawing is refused, and nothing changes", {}, async (world) => {
  const { studio, page } = world;
  await studio.open();
  await drop(page, "film.mp4", "video/mp4", Buffer.from("not a drawing"));
  const { isBlank, undo } = await studio.until("a problem is told", (state) =>
    state.notices.some(({ severity }) => severity === "problem"),
  );
  assert.deepEqual([isBlank, undo], [true, null]);
});

test("Ctrl+S gives the project, and what it gives can be opened again", {}, async (world) => {
  const { studio, page, keys } = world;
  await studio.open();
  await drop(page, "goose.svg", "image/svg+xml", await drawing());
  await studio.until("opened", (state) => !state.isBlank);
  const { name, bytes } = await studio.download(() => keys.press("Control+s"));
  assert.equal(name, "goose.inkflate");
  const before = await studio.written("svg");
  await studio.act("new");
  await studio.until("blank", (state) => state.isBlank);
  await drop(page, name, "", bytes);
  await studio.until("opened again", (state) => !state.isBlank);
  assert.deepEqual(await studio.written("svg"), before);
});

test("a new version waits until the person asks for it", { timeoutS: 120 }, async (world) => {
  const { studio, page, watch } = world;
  const folder = await mkdtemp(join(tmpdir(), "studio-"));
  await cp(studioFolder, folder, { recursive: true });
  const server = await servePlainly(folder);
  watch.origin = server.origin;
  studio.origin = server.origin;
  try {
    await studio.open();
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    const worker = join(folder, "sw.js");
    const text = await readFile(worker, "utf8");
    await writeFile(worker, text.replace(/"version":"\w+"/, '"version":"newer"'));
    const find = async () => (await navigator.serviceWorker.getRegistration()).update();
    await page.evaluate(find);
    const reload = page.getByRole("button", { name: "Reload" });
    await reload.waitFor();
    const isWaiting = () =>
      page.evaluate(async () => {
        const { waiting } = await navigator.serviceWorker.getRegistration();
        return waiting !== null;
      });
    assert.equal(await isWaiting(), true);
    await Promise.all([page.waitForEvent("load"), reload.click()]);
    await studio.until("ready", (state) => !state.isStarting);
    assert.equal(await isWaiting(), false);
  } finally {
    await server.close();
    await rm(folder, { recursive: true });
  }
});
