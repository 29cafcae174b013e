// SPDX-License-Identifier: Apache-2.0
// Whether a line sticks to the hand while it bends: an outline of some 400 points, two pins, a limb that is dragged about.
import { tasksDuring } from "../harness/trace.mjs";
import { ms, openStudio, percentile } from "./open-studio.mjs";

const pointCount = 400;
const moveCount = 90;
const centre = [500, 470];

/** Somebody with a head and four limbs, 1000 px high, as one closed line. */
function outline() {
  const points = Array.from({ length: pointCount }, (_, index) => {
    const angle = (2 * Math.PI * index) / pointCount - Math.PI / 2;
    const radius = 170 + 300 * Math.cos(2.5 * (angle + Math.PI / 2)) ** 6;
    return [centre[0] + radius * Math.cos(angle), centre[1] + radius * Math.sin(angle)];
  });
  const path = points.map((point) => point.map((value) => value.toFixed(2)).join(" ")).join(" L ");
  return `<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="1000"><path d="M ${path} Z" fill="none" stroke="#000"/></svg>`;
}

/** The end of a limb. */
function tip(limb) {
  const angle = (2 * Math.PI * limb) / 5 - Math.PI / 2;
  return [centre[0] + 470 * Math.cos(angle), centre[1] + 470 * Math.sin(angle)];
}

/** Runs in the page: px of the window of a place of the canvas. */
function toWindow([x, y]) {
  const [a, b, c, d, e, f] = globalThis.inkflateCamera;
  return [a * x + c * y + e, b * x + d * y + f];
}

/** Runs in the page: keeps how the paper lies, and when frames come. */
function watchFrames() {
  globalThis.inkflateTimes = [];
  globalThis.inkflateStudio.onFrame((frame) => {
    if (frame.scene === null) return;
    globalThis.inkflateCamera = frame.scene.canvasToScreen;
    globalThis.inkflateTimes.push(performance.now());
  });
}

/** One move, and the screen's next frame: as a hand that is never faster than the screen. */
async function moveAbout({ page, mouse }, from) {
  for (let move = 1; move <= moveCount; ++move) {
    const angle = (2 * Math.PI * move) / 60;
    const far = 150 * Math.min(1, move / 30);
    const place = [from[0] + far * Math.sin(angle), from[1] + 0.5 * far * (1 - Math.cos(angle))];
    await mouse.send("mouseMoved", place, "left", 1);
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
  }
}

const sum = (values) => values.reduce((total, value) => total + value, 0);

export async function bending(browser, origin) {
  const world = await openStudio(browser, origin);
  const { studio, page, mouse } = world;
  await page.evaluate(watchFrames);
  await studio.openFile("somebody.svg", outline());
  await studio.until("opened", (state) => state.hasRoughStrokes);
  await studio.act("simplify");
  await studio.partsAre(1);
  await studio.act("zoom_fit");
  await studio.act("deform");
  await page.waitForTimeout(500);
  const at = (limb) => page.evaluate(toWindow, tip(limb));
  for (const limb of [2, 3]) await mouse.click(await at(limb));
  await studio.until("two pins", (state) => state.pins === 2);
  const from = await at(1);
  await mouse.press(from);
  // The first move makes the mesh.
  const first = await tasksDuring(browser, page, async () => {
    await mouse.send("mouseMoved", [from[0] + 8, from[1]], "left", 1);
    await page.waitForTimeout(400);
  });
  const tasks = await tasksDuring(browser, page, () => moveAbout(world, from));
  const before = await page.evaluate(() => globalThis.inkflateTimes.length);
  const start = await page.evaluate(() => performance.now());
  await mouse.send("mouseMoved", [from[0] - 120, from[1] + 120], "left", 1);
  await page.waitForTimeout(1500);
  const settling = (await page.evaluate(() => globalThis.inkflateTimes)).slice(before);
  const resting = await tasksDuring(browser, page, () => page.waitForTimeout(1000));
  await mouse.release([from[0] - 120, from[1] + 120]);
  const state = await studio.until("bent", (each) => each.undo === "deform");
  await world.context.close();
  return [
    ["parts, pins", `${state.layers.length}, ${state.pins}`],
    ["first move: longest task of the worker, processor time", ms(first.worker[0] ?? NaN)],
    [`processor time per move of the worker, of ${moveCount}`, ms(sum(tasks.worker) / moveCount)],
    ["the same of the page", ms(sum(tasks.main) / moveCount)],
    ["longest tasks of the worker", tasks.worker.slice(0, 3).map(ms).join(", ")],
    [
      "tasks of the worker: 95 of 100",
      ms(
        percentile(
          tasks.worker.filter((t) => t > 0.5),
          0.95,
        ),
      ),
    ],
    ["longest tasks of the page", tasks.main.slice(0, 3).map(ms).join(", ")],
    ["frames until it rests, after a jump", String(settling.length)],
    ["from the jump until it rests", ms((settling.at(-1) ?? start) - start)],
    ["processor time of the worker in a second of rest", ms(sum(resting.worker))],
  ];
}
