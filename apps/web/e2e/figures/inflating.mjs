// SPDX-License-Identifier: Apache-2.0
// Simplify and Inflate as a person waits for them, beside the same steps of the native program.
import { spawnSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { topFolder } from "../harness/folders.mjs";
import { tasksDuring } from "../harness/trace.mjs";
import { ms, openStudio, percentile } from "./open-studio.mjs";

const program = join(topFolder, "build/release/inkflate");
const sketch = join(topFolder, "examples/sketches/crab.svg");
const character = join(topFolder, "build/gallery/dog.inkflate");
const runs = 7;

/** Runs in the page: from an action to the frame that shows what it has done. */
function timed([action, kind]) {
  const studio = globalThis.inkflateStudio;
  return new Promise((resolve) => {
    const start = performance.now();
    const stop = studio.onFrame((frame) => {
      const isDone = kind === "model" ? frame.scene?.model?.mesh : frame.state?.layers.length > 0;
      if (!isDone) return;
      stop();
      resolve(performance.now() - start);
    });
    studio.act(action);
  });
}

async function inStudio({ studio, page }, file, action, kind) {
  const times = [];
  for (let run = 0; run < runs; ++run) {
    await studio.act("mode_draw");
    await studio.act("new");
    await studio.until("blank", (state) => state.isBlank);
    await studio.openFile(`drawing${extname(file)}`, readFileSync(file));
    const wanted = (state) => (kind === "model" ? state.layers.length > 0 : state.hasRoughStrokes);
    await studio.until("opened", wanted);
    await page.waitForTimeout(400);
    times.push(await page.evaluate(timed, [action, kind]));
  }
  return { first: times[0], median: percentile(times, 0.5) };
}

/** Median ms of the native editor for a recording. */
function replayed(folder, events) {
  const recording = join(folder, "recording.jsonl");
  writeFileSync(recording, events.map((event) => `${JSON.stringify(event)}\n`).join(""));
  const times = [];
  for (let run = 0; run < runs; ++run) {
    const start = performance.now();
    const { status } = spawnSync(program, ["replay", recording, "--quiet"]);
    if (status !== 0) return NaN;
    times.push(performance.now() - start);
  }
  return percentile(times, 0.5);
}

/** What one key costs the native editor: a recording with it less the same one without. */
function native(folder, file, key) {
  // Recordings open what lies beside them.
  const open = { open: `drawing${extname(file)}` };
  copyFileSync(file, join(folder, open.open));
  return replayed(folder, [open, { key }]) - replayed(folder, [open]);
}

export async function inflating(browser, origin) {
  const world = await openStudio(browser, origin);
  const { studio, page } = world;
  const folder = mkdtempSync(join(tmpdir(), "inkflate-"));
  const simplify = await inStudio(world, sketch, "simplify", "parts");
  const inflate = await inStudio(world, character, "mode_inflate", "model");
  const rows = [
    ["simplify crab.svg: median, first", `${ms(simplify.median)}, ${ms(simplify.first)}`],
    ["simplify crab.svg: native", ms(native(folder, sketch, "Enter"))],
    ["inflate dog.inkflate: median, first", `${ms(inflate.median)}, ${ms(inflate.first)}`],
    ["inflate dog.inkflate: native", ms(native(folder, character, "2"))],
  ];
  rmSync(folder, { recursive: true });

  // Another drawing than the last: its model is made from nothing.
  await studio.act("mode_draw");
  await studio.act("new");
  await studio.openFile("drawing.inkflate", readFileSync(character));
  await studio.until("opened", (state) => state.layers.length > 0);
  const tasks = await tasksDuring(browser, page, async () => {
    await studio.act("mode_inflate");
    await page.waitForTimeout(1500);
  });
  await world.context.close();
  return [
    ...rows,
    ["longest task of the page, processor time", ms(tasks.main[0])],
    ["longest task of the core's worker, processor time", ms(tasks.worker[0] ?? NaN)],
  ];
}
