// SPDX-License-Identifier: Apache-2.0
// What a long session leaves behind.
import { drawCharacter } from "../harness/drawn.mjs";
import { memoryOf } from "../harness/memory.mjs";
import { manyStrokes } from "./drawing.mjs";
import { MB, openStudio } from "./open-studio.mjs";

const told = ({ pageMB, workerMB, processesMB }) =>
  `page ${MB(pageMB)}, worker ${MB(workerMB)}, processes ${MB(processesMB)}`;

export async function memory(browser, origin) {
  const world = await openStudio(browser, origin);
  const { studio, page, mouse } = world;
  const rows = [["empty", told(await memoryOf(page))]];
  await mouse.strokes(manyStrokes(2000, await studio.sheet()));
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
