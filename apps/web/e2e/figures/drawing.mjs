// SPDX-License-Identifier: Apache-2.0
// Whether ink sticks to the pen: while 500 strokes are drawn, and after them.
import { seededRandom } from "../harness/random.mjs";
import { tasksDuring } from "../harness/trace.mjs";
import { ms, openStudio, percentile } from "./open-studio.mjs";

const strokeCount = 500;
const pointCount = 20;

/** Short arcs all over the sheet. */
export function manyStrokes(count, sheet, seed = 5) {
  const random = seededRandom(seed);
  return Array.from({ length: count }, () => {
    const [x, y] = [sheet.x + random() * sheet.width, sheet.y + random() * sheet.height];
    const [turn, radius] = [random() * 2 * Math.PI, 20 + 60 * random()];
    return Array.from({ length: pointCount }, (_, index) => {
      const angle = turn + (2 * index) / pointCount;
      return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
    });
  });
}

/** Runs in the page: from each pointer event to the frame that follows it, and how long its own handlers took. */
function watchPointer() {
  globalThis.inkflateDelays = [];
  globalThis.inkflateFrames = [];
  const note = (event) => {
    const time = event.timeStamp;
    requestAnimationFrame(() => {
      globalThis.inkflateDelays.push(performance.now() - time);
    });
  };
  globalThis.addEventListener("pointermove", note, true);
  let last = performance.now();
  const frame = (now) => {
    globalThis.inkflateFrames.push(now - last);
    last = now;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

/** Runs in the page: whether a pointer's event leaves ink on a canvas before the next frame is shown. */
function watchInk(place) {
  const [x, y] = place;
  const inked = () =>
    [...document.querySelectorAll("canvas")].map((canvas) => {
      const context = canvas.getContext("2d");
      if (context === null) return "";
      const box = canvas.getBoundingClientRect();
      const scale = canvas.width / box.width;
      const at = [(x - box.left) * scale - 4, (y - box.top) * scale - 4];
      return String(context.getImageData(at[0], at[1], 9, 9).data);
    });
  globalThis.inkflateInk = { frames: null };
  const before = inked().join();
  const look = (count) => {
    if (inked().join() !== before) globalThis.inkflateInk.frames = count;
    else if (count < 60) requestAnimationFrame(() => look(count + 1));
  };
  globalThis.addEventListener("pointermove", (event) => {
    if (event.buttons !== 0 && Math.abs(event.clientX - x) < 2)
      requestAnimationFrame(() => look(0));
  });
}

async function framesToInk({ page, mouse }) {
  await page.evaluate(watchInk, [700, 400]);
  await mouse.press([500, 400]);
  await mouse.send("mouseMoved", [600, 400], "left", 1);
  await mouse.send("mouseMoved", [700, 400], "left", 1);
  await page.waitForTimeout(500);
  const { frames } = await page.evaluate(() => globalThis.inkflateInk);
  await mouse.release([700, 400]);
  return frames;
}

export async function drawing(browser, origin) {
  const world = await openStudio(browser, origin);
  const { studio, page, mouse } = world;
  const frames = await framesToInk(world);
  await studio.act("new");
  const strokes = manyStrokes(strokeCount, await studio.sheet());
  await page.evaluate(watchPointer);
  const start = Date.now();
  const tasks = await tasksDuring(browser, page, () => mouse.strokes(strokes));
  const seconds = (Date.now() - start) / 1000;
  const seen = await page.evaluate(() => [globalThis.inkflateDelays, globalThis.inkflateFrames]);
  const [delays, times] = seen;
  await world.context.close();
  return [
    ["frames from a pointer's event to ink on the canvas", frames === null ? "never" : `${frames}`],
    [`${strokeCount} strokes of ${pointCount} points took`, `${seconds.toFixed(1)} s`],
    ["pointer to frame, median", ms(percentile(delays, 0.5))],
    ["pointer to frame, 95 of 100", ms(percentile(delays, 0.95))],
    ["between frames, 95 of 100", ms(percentile(times, 0.95))],
    ["longest task of the page, processor time", ms(tasks.main[0])],
    [
      "tasks of the page over 50 ms of processor time",
      String(tasks.main.filter((time) => time > 50).length),
    ],
    ["longest task of the core's worker, processor time", ms(tasks.worker[0] ?? NaN)],
  ];
}
