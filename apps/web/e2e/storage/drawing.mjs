// SPDX-License-Identifier: Apache-2.0
// Draws on and on in an open studio, as quickly as it takes, and counts what is left of it.
import assert from "node:assert/strict";
import { inflateRawSync } from "node:zlib";

/** How often something is tried; all of it with --long. */
export const times = (short, long) => (process.argv.includes("--long") ? long : short);

export const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/**
 * Runs in the page: draws strokes until the page is gone, or as many as are wanted. Tells by the console when one is finished, and when the
 * studio has said that it is saved.
 */
async function drawOn({ seed, most }) {
  const studio = globalThis.inkflateStudio;
  let state = seed;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  let taken = 0;
  studio.onFrame((frame) => (taken = frame.sequence));
  const turn = () => new Promise((resolve) => setTimeout(resolve, 1 + 12 * random()));
  const start = performance.now();
  const point = (action, x, y) => {
    const button = action === "move" ? "none" : "primary";
    const modifiers = { isShift: false, isCtrl: false, isAlt: false };
    const timeS = (performance.now() - start) / 1000;
    const what = { type: "pointer", kind: "mouse", id: 1, pressure: 0.5 };
    return studio.send({ ...what, action, button, x, y, timeS, modifiers });
  };
  for (let count = 1; count <= most; ++count) {
    const [left, y] = [200 + 300 * random(), 150 + 300 * random()];
    point("press", left, y);
    for (let step = 1; step <= 6; ++step) {
      await turn();
      point("move", left + 20 * step, y + 8 * random());
    }
    const last = point("release", left + 120, y);
    console.debug(`finished ${count}`);
    // Half of the time it draws on at once, so that a kill finds writes of all kinds under way.
    if (count < most && random() < 0.5) continue;
    while (taken < last || studio.saveState.value.kind === "saving") await turn();
    if (studio.saveState.value.kind === "saved") console.debug(`saved ${count}`);
  }
}

/** Loads the page again: the address stays, so that going there would do nothing. */
export async function openAgain(studio) {
  await studio.page.reload();
  await studio.until("the studio is ready again", (state) => !state.isStarting);
}

/** What a page has told so far. */
export function watchDrawing(page) {
  const told = { finishedMs: [], saved: 0 };
  page.on("console", (message) => {
    const [what, count] = message.text().split(" ");
    if (what === "finished") told.finishedMs.push(Date.now());
    if (what === "saved") told.saved = Number(count);
  });
  return told;
}

/** Draws until stopped by the end of the page. */
export function drawForever(page, seed) {
  page.evaluate(drawOn, { seed, most: 1e9 }).catch(() => null);
}

/** Draws so many strokes and waits until the studio has said how safe they are. */
export function drawSome(page, seed, count) {
  return page.evaluate(drawOn, { seed, most: count });
}

/** The first entry of a project's archive. */
function documentOf(project) {
  const nameLength = project.readUInt16LE(26) + project.readUInt16LE(28);
  const size = project.readUInt32LE(18);
  const content = project.subarray(30 + nameLength, 30 + nameLength + size);
  const isDeflated = project.readUInt16LE(8) === 8;
  return JSON.parse(isDeflated ? inflateRawSync(content) : content);
}

/** How many strokes the open drawing has. */
export async function strokesIn(page) {
  const base64 = await page.evaluate(async () => {
    const studio = globalThis.inkflateStudio;
    if (studio.state.value.isBlank) return "";
    const [file] = await studio.exportAs("inkflate");
    // A call takes so many arguments and no more.
    const pieces = [];
    for (let at = 0; at < file.bytes.length; at += 4096) {
      pieces.push(String.fromCharCode(...file.bytes.subarray(at, at + 4096)));
    }
    return btoa(pieces.join(""));
  });
  return base64 === "" ? 0 : documentOf(Buffer.from(base64, "base64")).strokes.length;
}

/** Longer than this, no finished stroke may be in memory alone; machines that build beside the tests are slow. */
const latestMs = 2000;

/** What was said to be saved is there, and whatever was finished a while before the end. */
export function assertKept({ before, told, endMs, found, what }) {
  const kept = found - before;
  const due = told.finishedMs.filter((ms) => ms < endMs - latestMs).length;
  assert.ok(kept >= told.saved, `${what}: ${told.saved} were said to be saved, ${kept} are there`);
  assert.ok(kept >= due, `${what}: ${due} were finished long before, ${kept} are there`);
}
