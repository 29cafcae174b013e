// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { characterOn } from "../harness/drawn.mjs";
import { readPng } from "../harness/png.mjs";
import { test } from "../harness/tests.mjs";

const tablet = { device: "tablet" };

/** How many dark pixels lie above one another here. */
function inkHeight(picture, x, y) {
  let count = 0;
  for (let dy = -30; dy <= 30; ++dy) if (picture.at(x, y + dy)[0] < 140) ++count;
  return count;
}

test("a line is as wide as the pen is pressed", tablet, async ({ studio, pen, picture }) => {
  await studio.open();
  await studio.act("brush_size", "16");
  const from = 250;
  const points = Array.from({ length: 40 }, (_, index) => [from + index * 15, 400]);
  await pen.stroke(points, { force: (share) => 0.05 + 0.95 * share });
  await studio.until("a stroke", (state) => state.hasRoughStrokes);
  await studio.atRest();
  const drawn = readPng(await picture("pressed"));
  const [light, strong] = [inkHeight(drawn, from + 60, 400), inkHeight(drawn, from + 540, 400)];
  assert.ok(light >= 1 && strong > 1.5 * light, `${light} px and ${strong} px`);
});

test("a palm beside the pen draws nothing, and fingers pan from then on", tablet, async (world) => {
  const { studio, pen, touch } = world;
  await studio.open();
  await pen.press([400, 400], { force: 0.4 });
  await touch.send("touchStart", [[600, 600]]);
  await pen.send("mouseMoved", [420, 430], "left", 1, { force: 0.6 });
  await touch.send("touchMove", [[604, 603]]);
  await pen.send("mouseMoved", [460, 470], "left", 1, { force: 0.6 });
  await touch.send("touchEnd", []);
  await pen.release([460, 470]);
  await studio.until("a stroke", (state) => state.hasRoughStrokes);
  const drawn = await studio.written("svg");
  await touch.stroke([
    [300, 300],
    [350, 320],
    [400, 340],
  ]);
  assert.deepEqual(await studio.written("svg"), drawn);
  await studio.act("undo");
  await studio.until("blank", (state) => state.isBlank);
});

test("the pen's other end erases", tablet, async ({ studio, pen, picture }) => {
  await studio.open();
  await pen.stroke(
    [
      [300, 400],
      [400, 400],
      [500, 400],
      [600, 400],
    ],
    { force: () => 0.5 },
  );
  const whole = await studio.until("a stroke", (state) => state.hasRoughStrokes);
  await pen.turn(true);
  await pen.stroke(
    [
      [450, 340],
      [450, 400],
      [450, 460],
    ],
    { force: () => 0.5 },
  );
  await pen.turn(false);
  await picture("erased");
  await studio.until("an erasure", (state) => state.undo !== whole.undo);
});

test("a pen draws a whole part", tablet, async ({ studio, page, pen }) => {
  await studio.open();
  const { body } = await characterOn(studio);
  await pen.strokes(body, { force: (share) => 0.3 + 0.5 * Math.sin(Math.PI * share) });
  await page.getByRole("button", { name: "Simplify" }).first().tap();
  await studio.partsAre(1);
});
