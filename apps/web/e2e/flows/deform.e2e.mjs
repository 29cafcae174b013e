// SPDX-License-Identifier: Apache-2.0
// Lines are dragged, and bend as one expects.
import assert from "node:assert/strict";
import { deform, withArm, withBar } from "../harness/bendable.mjs";
import { characterOn, drawPart, inflate } from "../harness/drawn.mjs";
import { assertValidGlb } from "../harness/judges.mjs";
import { readPng } from "../harness/png.mjs";
import { test } from "../harness/tests.mjs";

/** What is drawn; pins are not. */
async function text(studio) {
  return String(await studio.written("svg")).replaceAll(/ inkflate:bend-pins="[^"]*"/g, "");
}

const paper = [251, 248, 242];
/** Neither ink, fill nor the white around what is selected. */
const isPaper = (pixel) => pixel.every((value, channel) => Math.abs(value - paper[channel]) <= 1);
/** Ink, or the blue of what is selected. */
const isLine = ([red]) => red < 120;

/** Whether a line runs through a small square. */
function hasLine(picture, [x, y], halfSidePx = 8) {
  for (let dy = -halfSidePx; dy <= halfSidePx; ++dy) {
    for (let dx = -halfSidePx; dx <= halfSidePx; ++dx) {
      if (isLine(picture.at(x + dx, y + dy))) return true;
    }
  }
  return false;
}

/** From now on the page remembers whether it has said that work takes long. */
function watchLongWork(page) {
  return page.evaluate(() => {
    globalThis.inkflateStudio.longWork.subscribe((work) => {
      if (work !== null) globalThis.inkflateWorkedLong = true;
    });
  });
}

test("an arm that is dragged bends; undo and redo give each picture back", {}, async (world) => {
  const { studio, page, mouse, keys, picture } = world;
  const { tip, place } = await withArm(world, mouse);
  const before = await text(studio);
  await watchLongWork(page);
  const raised = place([800, 60]);
  await mouse.drag(tip, raised, { steps: 30 });
  await studio.until("bent", (state) => state.undo === "deform");
  await studio.atRest();
  const bent = await text(studio);
  assert.notEqual(bent, before);
  const drawn = readPng(await picture("bent"));
  assert.ok(hasLine(drawn, raised), "the line has not come along");
  assert.ok(!hasLine(drawn, tip), "the line is still there");
  await keys.press("Control+z");
  await studio.until("undone", (state) => state.undo !== "deform");
  assert.equal(await text(studio), before);
  await studio.atRest();
  assert.ok(hasLine(readPng(await picture("undone")), tip));
  await keys.press("Control+Shift+z");
  await studio.until("redone", (state) => state.undo === "deform");
  assert.equal(await text(studio), bent);
  assert.equal(await page.evaluate(() => globalThis.inkflateWorkedLong), undefined);
});

test("a click on a line sets a pin, and Esc drops what is being bent", {}, async (world) => {
  const { studio, mouse, keys, picture } = world;
  const place = await withBar(world, mouse);
  await mouse.click(place([500, 700]));
  await studio.until("a pin", (state) => state.pins === 1 && state.hasPin);
  await mouse.click(place([420, 450]));
  await studio.until("two pins", (state) => state.pins === 2);
  await picture("pins");
  const before = await text(studio);
  await mouse.press(place([500, 200]));
  for (let step = 1; step <= 10; ++step) {
    await mouse.send("mouseMoved", place([500 + 20 * step, 200]), "left", 1);
  }
  await picture("bending");
  await keys.press("Escape");
  await mouse.release(place([700, 200]));
  assert.equal((await studio.atRest()).undo, "add_pin");
  assert.equal(await text(studio), before);
  await mouse.drag(place([500, 200]), place([700, 230]), { steps: 20 });
  await studio.until("bent", (state) => state.undo === "deform");
  await picture("bent");
  assert.notEqual(await text(studio), before);
});

test("a hand at rest lets the drawing settle, and then nothing goes on", {}, async (world) => {
  const { studio, page, mouse } = world;
  const place = await withBar(world, mouse);
  await mouse.click(place([500, 700]));
  await studio.until("a pin", (state) => state.pins === 1);
  await mouse.press(place([500, 200]));
  await mouse.send("mouseMoved", place([540, 210]), "left", 1);
  await page.evaluate(() => {
    globalThis.inkflateFrames = 0;
    globalThis.inkflateStudio.onFrame(() => ++globalThis.inkflateFrames);
  });
  const framesOf = async (doing) => {
    const before = await page.evaluate(() => globalThis.inkflateFrames);
    await doing();
    return (await page.evaluate(() => globalThis.inkflateFrames)) - before;
  };
  const settling = await framesOf(async () => {
    await mouse.send("mouseMoved", place([760, 300]), "left", 1);
    await studio.atRest();
  });
  assert.ok(settling > 2, `it settled in ${settling} frames`);
  assert.equal(await framesOf(() => page.waitForTimeout(600)), 0);
  await mouse.release(place([760, 300]));
  await studio.until("bent", (state) => state.undo === "deform");
});

test("a limb that lies over its own body is filled there", {}, async (world) => {
  const { studio, page, mouse, picture } = world;
  await studio.open();
  const { place } = await characterOn(studio);
  const outline = [
    [150, 150],
    [400, 150],
    [400, 250],
    [860, 250],
    [880, 285],
    [860, 320],
    [400, 320],
    [400, 650],
    [150, 650],
    [150, 153],
  ];
  await drawPart(world, mouse, [outline.map(place)], 1);
  await deform(world);
  for (const pin of [
    [150, 400],
    [275, 650],
    [275, 150],
  ]) {
    await mouse.click(place(pin));
  }
  await studio.until("three pins", (state) => state.pins === 3);
  const way = [
    [880, 285],
    [850, 480],
    [700, 620],
    [520, 600],
    [400, 560],
    [290, 520],
  ];
  const smooth = way.slice(1).flatMap((to, index) => {
    const from = way[index];
    return [0.2, 0.4, 0.6, 0.8, 1].map((t) => [
      from[0] + (to[0] - from[0]) * t,
      from[1] + (to[1] - from[1]) * t,
    ]);
  });
  await mouse.stroke([way[0], ...smooth].map(place));
  await studio.until("bent", (state) => state.undo === "deform");
  await page.mouse.move(20, 500);
  await studio.atRest();
  const drawn = readPng(await picture("crossed"));
  const [x, y] = place(way.at(-1));
  assert.ok(hasLine(drawn, [x, y]), "the limb does not lie over the body");
  let holes = 0;
  for (let dy = -40; dy <= 40; ++dy) {
    for (let dx = -40; dx <= 40; ++dx) if (isPaper(drawn.at(x + dx, y + dy))) ++holes;
  }
  assert.ok(isPaper(drawn.at(...place([900, 600]))), "paper looks otherwise");
  assert.equal(holes, 0, "there is a hole where the limb lies over the body");
});

test("what was bent is there after a reload, with its pins, and is inflated", {}, async (world) => {
  const { studio, page, mouse, keys } = world;
  const { tip, place } = await withArm(world, mouse);
  await mouse.click(place([672, 357]));
  await studio.until("a pin", (state) => state.pins === 1);
  await mouse.drag(tip, place([820, 120]), { steps: 20 });
  await studio.until("bent", (state) => state.undo === "deform");
  await studio.saved();
  const bent = await text(studio);
  await page.reload();
  await studio.until("ready again", (state) => !state.isStarting && state.layers.length === 2);
  assert.equal(await text(studio), bent);
  assert.equal((await studio.atRest()).pins, 1);
  await keys.press("d");
  await keys.press("n");
  await studio.until("the pin", (state) => state.hasPin);
  await inflate(world);
  await assertValidGlb(await studio.written("glb"));
});

test("pins are set, moved, turned and deleted by keys alone", {}, async (world) => {
  const { studio, page, keys, mouse, picture } = world;
  await withBar(world, mouse);
  const said = () => page.getByRole("status").allTextContents();
  await keys.press("Control+a");
  await studio.until("selected", (state) => state.layers[0].isSelected);
  const before = await text(studio);
  await keys.press("Shift+D");
  await studio.until("a pin", (state) => state.pins === 1 && state.hasPin);
  await keys.press("Shift+D");
  await studio.until("another pin", (state) => state.pins === 2);
  assert.equal(await text(studio), before);
  await keys.press("n");
  await studio.until("the first pin", (state) => state.hasPin);
  await studio.atRest();
  assert.match((await said()).join(" "), /Pin 1\/2/);
  for (let press = 0; press < 4; ++press) await keys.press("Shift+ArrowRight");
  await studio.until("moved", (state) => state.undo === "deform");
  const moved = await text(studio);
  assert.notEqual(moved, before);
  await keys.press(".");
  await keys.press(".");
  await studio.atRest();
  await picture("turned");
  assert.notEqual(await text(studio), moved);
  await keys.press("Delete");
  const left = await studio.until("one pin less", (state) => state.pins === 1);
  assert.equal(left.layers.length, 1);
  await keys.press("Escape");
  await studio.until("no pin", (state) => !state.hasPin && state.tool === "deform");
});

for (const device of ["tablet", "phone"]) {
  test(`${device}: a finger bends, a tap sets a pin and takes it`, { device }, async (world) => {
    const { studio, page, touch, picture } = world;
    const place = await withBar(world, touch);
    await touch.tap(place([500, 700]));
    await studio.until("a pin", (state) => state.pins === 1 && state.hasPin);
    await touch.tap(place([420, 450]));
    await studio.until("two pins", (state) => state.pins === 2);
    const before = await text(studio);
    const way = Array.from({ length: 20 }, (_, step) => place([500 + 10 * step, 200 + 2 * step]));
    await touch.stroke(way);
    await studio.until("bent", (state) => state.undo === "deform");
    await picture("bent");
    assert.notEqual(await text(studio), before);
    // Half a finger beside it.
    const [x, y] = place([500, 700]);
    await touch.tap([x + 12, y - 10]);
    await studio.until("still two pins", (state) => state.pins === 2 && state.hasPin);
    await page.getByRole("button", { name: "Delete pin", exact: true }).tap();
    await studio.until("one pin", (state) => state.pins === 1);
  });
}

test("a pen bends what it drags", { device: "tablet" }, async (world) => {
  const { studio, pen } = world;
  const { tip, place } = await withArm(world, pen);
  await pen.drag(tip, place([820, 120]), { steps: 20 });
  await studio.until("bent", (state) => state.undo === "deform");
});
