// SPDX-License-Identifier: Apache-2.0
// What a long session leaves behind.
import { drawCharacter } from "../harness/drawn.mjs";
import { memoryOf } from "../harness/memory.mjs";
import { MB, openStudio } from "./open-studio.mjs";

const told = ({ pageMB, workerMB, processesMB }) =>
  `page ${MB(pageMB)}, worker ${MB(workerMB)}, processes ${MB(processesMB)}`;

/** Runs in the page: draws strokes as pointers would, each after the frame that shows the one before. */
async function drawMany({ count, width, height }) {
  const studio = globalThis.inkflateStudio;
  const modifiers = { isShift: false, isCtrl: false, isAlt: false };
  const what = { type: "pointer", kind: "mouse", id: 1, pressure: 0.5, modifiers };
  let taken = 0;
  const stop = studio.onFrame((frame) => (taken = frame.sequence));
  for (let stroke = 0; stroke < count; ++stroke) {
    const [left, top] = [
      150 + ((stroke * 37) % (width - 400)),
      150 + ((stroke * 61) % (height - 300)),
    ];
    const point = (action, step) => {
      const button = action === "move" ? "none" : "primary";
      const [x, y] = [left + 9 * step, top + 20 * Math.sin(step)];
      return studio.send({ ...what, action, button, x, y, timeS: stroke + step / 100 });
    };
    point("press", 0);
    for (let step = 1; step < 12; ++step) point("move", step);
    const last = point("release", 12);
    while (taken < last) await new Promise((resolve) => setTimeout(resolve));
  }
  stop();
}

export async function memory(browser, origin) {
  const world = await openStudio(browser, origin);
  const { studio, page, mouse } = world;
  const rows = [["empty", told(await memoryOf(page))]];
  const { width, height } = page.viewportSize();
  await page.evaluate(drawMany, { count: 2000, width, height });
  rows.push(["2000 strokes", told(await memoryOf(page))]);
  for (let count = 0; count < 500; ++count) await studio.act("undo");
  await studio.until("undone", (state) => state.redo !== null);
  rows.push(["500 of them undone", told(await memoryOf(page))]);
  await studio.act("new");
  await drawCharacter(world, mouse);
  for (let count = 0; count < 100; ++count) {
    await studio.act("mode_inflate");
    await studio.until("the model", (state) => state.mode === "inflate" && !state.isWorking);
    await studio.act("mode_draw");
    await studio.act("flip_horizontal");
    await studio.until("drawing", (state) => state.mode === "draw");
  }
  rows.push(["100 models", told(await memoryOf(page))]);
  await studio.act("new");
  await studio.until("blank", (state) => state.isBlank);
  rows.push(["new drawing", told(await memoryOf(page))]);
  await world.context.close();
  return rows;
}
