// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { characterOn, drawArm, drawCharacter, drawPart, inflate } from "../harness/drawn.mjs";
import { assertClosedStl, assertPrintable, assertValidGlb } from "../harness/judges.mjs";
import { countDifferent, readPng } from "../harness/png.mjs";
import { test } from "../harness/tests.mjs";

const names = (state) => state.layers.map((layer) => layer.name);

test("strokes with gaps close into a part, and undo opens it again", {}, async (world) => {
  const { studio, mouse, keys, picture } = world;
  await studio.open();
  const { body } = await characterOn(studio);
  await mouse.strokes(body);
  await studio.until("loose strokes", (state) => state.hasRoughStrokes);
  await picture("rough");
  await keys.press("Enter");
  await studio.partsAre(1);
  await picture("closed");
  await keys.press("Control+z");
  const undone = await studio.partsAre(0);
  assert.ok(undone.hasRoughStrokes);
  await keys.press("Control+Shift+z");
  await studio.partsAre(1);
});

test("a piece that is erased can be drawn again", {}, async (world) => {
  const { studio, mouse, keys, picture } = world;
  await studio.open();
  const { body, place } = await characterOn(studio);
  await mouse.strokes(body);
  await keys.press("e");
  await studio.until("the eraser", (state) => state.tool === "eraser");
  await mouse.stroke(
    [
      [640, 330],
      [670, 480],
      [660, 620],
    ].map(place),
  );
  await picture("erased");
  await keys.press("b");
  await mouse.stroke(
    [
      [610, 300],
      [720, 380],
      [730, 520],
      [700, 600],
      [600, 680],
    ].map(place),
  );
  await keys.press("Enter");
  await studio.partsAre(1);
});

test("a limb is joined by a help line, copied, and sent to the back", {}, async (world) => {
  const { studio, mouse, keys, picture } = world;
  await studio.open();
  const { body, near, place } = await characterOn(studio);
  await drawPart(world, mouse, body, 1);
  await drawArm(world, mouse, near, 2);
  await picture("joined");
  await keys.press("v");
  await mouse.click(place([800, 350]));
  await studio.until("a selection", (state) => state.layers.some((layer) => layer.isSelected));
  await keys.press("Control+d");
  const before = await studio.partsAre(3);
  await keys.press("End");
  const after = await studio.until(
    "another order",
    (state) => names(state).join() !== names(before).join(),
  );
  assert.ok(after.layers.at(-1).isSelected);
});

test("a character is inflated, turned, exported and printed", {}, async (world) => {
  const { studio, mouse, picture } = world;
  await studio.open();
  const { place } = await drawCharacter(world, mouse);
  await picture("drawn");
  await inflate(world);
  const front = readPng(await picture("front"));
  await mouse.drag(place([500, 500]), place([750, 460]));
  await studio.atRest();
  assert.ok(countDifferent(front, readPng(await picture("turned"))) > 2000, "it has not turned");
  await assertValidGlb(await studio.written("glb"));
  const print = await studio.written("stl");
  assertClosedStl(print);
  assertPrintable(print);
});

test("what was drawn is there after a reload, and can be saved and opened", {}, async (world) => {
  const { studio, page, mouse, keys } = world;
  await studio.open();
  const { body } = await characterOn(studio);
  await drawPart(world, mouse, body, 1);
  await studio.saved();
  const drawn = await studio.written("svg");
  await page.reload();
  await studio.until("ready again", (state) => !state.isStarting && state.layers.length === 1);
  assert.deepEqual(await studio.written("svg"), drawn);
  const saved = await studio.download(() => keys.press("Control+s"));
  assert.match(saved.name, /\.inkflate$/);
  await studio.act("new");
  await studio.partsAre(0);
  await studio.openFile(saved.name, saved.bytes);
  await studio.partsAre(1);
  assert.deepEqual(await studio.written("svg"), drawn);
});
