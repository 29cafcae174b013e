// SPDX-License-Identifier: Apache-2.0
// How much comes through the wire, and how long it takes, until the first stroke can be drawn.
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { brotliCompressSync, gzipSync } from "node:zlib";
import { devices } from "../harness/devices.mjs";
import { studioFolder } from "../harness/folders.mjs";
import { kB, ms, percentile } from "./open-studio.mjs";

const ready = () => globalThis.inkflateReady !== undefined;

/** Runs in the page before all else: the moment from which a stroke is taken. */
function watchStart() {
  let studio;
  Object.defineProperty(globalThis, "inkflateStudio", {
    get: () => studio,
    set: (value) => {
      studio = value;
      studio.isStarting.subscribe((isStarting) => {
        if (!isStarting) globalThis.inkflateReady ??= performance.now();
      });
    },
  });
}

/** Time from the click on the link until the core is there, and what was fetched until then. */
async function visitOnce(context, origin) {
  const page = await context.newPage();
  const requests = [];
  page.on("request", (request) => requests.push(request));
  await page.addInitScript(watchStart);
  await page.goto(`${origin}/#test`);
  await page.waitForFunction(ready, undefined, { polling: "raf" });
  const [whenReady, origo] = await page.evaluate(() => [
    globalThis.inkflateReady,
    performance.timeOrigin,
  ]);
  const early = requests.filter((request) => request.timing().startTime - origo <= whenReady);
  // The browser tells of a paint some frames after it.
  await page.waitForFunction(() => performance.getEntriesByType("paint").length > 0);
  const paint = await page.evaluate(() => performance.getEntriesByType("paint").at(-1).startTime);
  const times = { ready: whenReady, paint };
  await page.close();
  return { times, paths: [...new Set(early.map((each) => new URL(each.url()).pathname))] };
}

async function sizes(paths) {
  const rows = [];
  for (const path of paths) {
    const name = path === "/" ? "index.html" : path.slice(1);
    const bytes = await readFile(join(studioFolder, name)).catch(() => Buffer.alloc(0));
    const brotli = brotliCompressSync(bytes).length;
    rows.push({ name, plain: bytes.length, brotli, gzip: gzipSync(bytes, { level: 9 }).length });
  }
  return rows.sort((a, b) => b.brotli - a.brotli);
}

async function times(browser, origin) {
  const cold = [];
  const warm = [];
  for (let run = 0; run < 5; ++run) {
    const context = await browser.newContext(devices.wide);
    cold.push((await visitOnce(context, origin)).times);
    await new Promise((resolve) => setTimeout(resolve, 1500));
    warm.push((await visitOnce(context, origin)).times);
    await context.close();
  }
  const median = (runs, key) =>
    ms(
      percentile(
        runs.map((run) => run[key]),
        0.5,
      ),
    );
  return [
    ["first paint, first visit", median(cold, "paint")],
    ["first stroke possible, first visit", median(cold, "ready")],
    ["first stroke possible, later visits", median(warm, "ready")],
  ];
}

export async function load(browser, origin) {
  const context = await browser.newContext(devices.wide);
  const { paths } = await visitOnce(context, origin);
  await context.close();
  const files = await sizes(paths);
  const total = (key) => kB(files.reduce((sum, file) => sum + file[key], 0));
  return [
    ["files until the first stroke", String(files.length)],
    ["brotli, gzip, plain", [total("brotli"), total("gzip"), total("plain")].join(", ")],
    ...files.slice(0, 6).map((file) => [`  ${file.name}`, `${kB(file.brotli)}, ${kB(file.gzip)}`]),
    ...(await times(browser, origin)),
  ];
}
