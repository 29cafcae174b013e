// SPDX-License-Identifier: Apache-2.0
// The ways through the studio that have to feel right, from the first minute to a classroom without a network.
import assert from "node:assert/strict";
import { basename, join } from "node:path";
import { characterOn, drawArm, drawPart, inflate } from "../harness/drawn.mjs";
import { studioFolder } from "../harness/folders.mjs";
import { assertValidGlb } from "../harness/judges.mjs";
import { servePlainly } from "../harness/static-server.mjs";
import { test } from "../harness/tests.mjs";

test("first minute: a scribble becomes a model and leaves as a file", {}, async (world) => {
  const { studio, page, mouse, keys, picture } = world;
  await studio.open();
  await picture("empty");
  const { body, near, place } = await characterOn(studio);
  await mouse.strokes(body);
  await studio.until("loose strokes", (state) => state.hasRoughStrokes);
  await picture("scribble");
  await keys.press("Enter");
  await studio.partsAre(1);
  await drawArm(world, mouse, near, 2);
  await mouse.doubleClick(place([800, 350]));
  await studio.partsAre(3);
  await picture("far-arm");
  await inflate(world);
  await mouse.drag(place([500, 500]), place([700, 470]));
  await picture("turned");
  await keys.press("Control+Shift+e");
  const dialog = page.getByRole("dialog", { name: "Export" });
  await dialog.getByRole("radio", { name: /^GLB/ }).check();
  const save = dialog.getByRole("button", { name: "Save", disabled: false });
  await save.waitFor();
  await picture("export");
  const file = await studio.download(() => save.click());
  await assertValidGlb(file.bytes);
});

test("first minute: an example can be tapped", { device: "tablet" }, async (world) => {
  const { studio, page } = world;
  await studio.open();
  await page
    .getByRole("list", { name: /example/i })
    .getByRole("button")
    .first()
    .tap();
  const state = await studio.until("something drawn", (each) => !each.isBlank);
  assert.ok(state.hasRoughStrokes || state.layers.length > 0);
});

test("repair: a click opens a bay that was filled", {}, async (world) => {
  const { studio, mouse, keys, picture } = world;
  await studio.open();
  const place = (await characterOn(studio)).place;
  // A mug: a body, and a handle around a bay that is meant to stay open.
  const bowl = [
    [300, 250],
    [300, 600],
    [600, 600],
    [600, 250],
    [300, 250],
  ];
  const handle = [
    [600, 300],
    [760, 320],
    [780, 430],
    [740, 520],
    [600, 530],
  ];
  await mouse.strokes([bowl, handle].map((points) => points.map(place)));
  await keys.press("Enter");
  await studio.partsAre(1);
  await picture("filled");
  const filled = String(await studio.written("svg"));
  await keys.press("Control+z");
  await studio.partsAre(0);
  await keys.press("o");
  await mouse.click(place([680, 420]));
  await studio.until("a mark", (state) => state.marks === 1);
  await picture("marked");
  await keys.press("Enter");
  await studio.partsAre(1);
  await picture("opened");
  assert.notEqual(String(await studio.written("svg")), filled);
});

test("repair: the gap slider bridges a gap that stays open", {}, async (world) => {
  const { studio, page, mouse, keys, picture } = world;
  await studio.open();
  const { place } = await characterOn(studio);
  const bow = [];
  for (let angle = 0.5; angle < 2 * Math.PI - 0.5; angle += 0.1) {
    bow.push(place([500 - 220 * Math.cos(angle), 400 + 220 * Math.sin(angle)]));
  }
  await mouse.stroke(bow);
  await studio.until("loose strokes", (state) => state.hasRoughStrokes);
  const slider = page.getByRole("slider", { name: /gap/i });
  await slider.focus();
  await keys.press("Home");
  await picture("open");
  await keys.press("End");
  await studio.until("a large gap", (state) => state.gapPx !== null && state.gapPx > 100);
  await studio.atRest();
  await picture("bridged");
  await studio.act("simplify");
  await studio.partsAre(1);
});

test("change of mind: undo in the model goes back to the drawing step", {}, async (world) => {
  const { studio, mouse, keys, picture } = world;
  await studio.open();
  const { body, head } = await characterOn(studio);
  await drawPart(world, mouse, body, 1);
  await drawPart(world, mouse, head, 2);
  await inflate(world);
  await keys.press("Control+z");
  const state = await studio.partsAre(1);
  assert.equal(state.mode, "draw");
  await picture("undone");
  await keys.press("Control+Shift+z");
  await studio.partsAre(2);
});

test(
  "interruption: closed in the midst of a stroke, all but that stroke is there",
  {},
  async (world) => {
    const { studio, context, page, mouse, origin } = world;
    await studio.open();
    const { body, place } = await characterOn(studio);
    await drawPart(world, mouse, body, 1);
    await studio.saved();
    const kept = await studio.written("svg");
    await mouse.press(place([300, 200]));
    await mouse.send("mouseMoved", place([500, 250]), "left", 1);
    await page.close();
    const again = await context.newPage();
    const reopened = new studio.constructor(again, origin);
    await reopened.open();
    await reopened.partsAre(1);
    assert.deepEqual(await reopened.written("svg"), kept);
    assert.equal(await again.getByRole("dialog").count(), 0);
  },
);

test(
  "classroom: once loaded from any server, it opens without a network",
  { timeoutS: 90 },
  async (world) => {
    const { studio, page, mouse, watch } = world;
    const server = await servePlainly(join(studioFolder, ".."));
    watch.origin = server.origin;
    studio.origin = server.origin;
    await studio.open(`/${basename(studioFolder)}/#test`);
    await page.evaluate(async () => {
      const { active } = await navigator.serviceWorker.ready;
      if (active.state === "activated") return;
      await new Promise((resolve) => active.addEventListener("statechange", resolve));
    });
    await server.close();
    await page.reload();
    await studio.until("ready without a network", (state) => !state.isStarting);
    const { body } = await characterOn(studio);
    await drawPart(world, mouse, body, 1);
    await inflate(world);
    await assertValidGlb(await studio.written("glb"));
  },
);
