// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { characterOn, drawPart } from "../harness/drawn.mjs";
import { countDifferent, readPng } from "../harness/png.mjs";
import { test } from "../harness/tests.mjs";

for (const device of ["tablet", "phone"]) {
  test(`${device}: a finger draws, two fingers undo, three redo`, { device }, async (world) => {
    const { studio, page, touch } = world;
    await studio.open();
    const { body, place } = await characterOn(studio);
    await touch.strokes(body);
    await studio.until("loose strokes", (state) => state.hasRoughStrokes);
    await page.getByRole("button", { name: "Simplify" }).first().tap();
    await studio.partsAre(1);
    const [left, right] = [place([400, 450]), place([600, 450])];
    await touch.tap(left, right);
    await studio.partsAre(0);
    await touch.tap(left, place([500, 450]), right);
    await studio.partsAre(1);
  });

  test(
    `${device}: two fingers move, zoom and leave the drawing alone`,
    { device },
    async (world) => {
      const { studio, touch, picture } = world;
      await studio.open();
      const { body, place } = await characterOn(studio);
      await drawPart(world, touch, body, 1);
      const before = await studio.atRest();
      await touch.pinch(
        [place([400, 450]), place([600, 450])],
        [place([300, 450]), place([700, 450])],
      );
      const zoomed = await studio.atRest();
      assert.ok(zoomed.zoom > 1.5 * before.zoom);
      await picture("zoomed");
      await touch.pinch(
        [place([400, 450]), place([600, 450])],
        [place([400, 650]), place([600, 650])],
      );
      const moved = await studio.atRest();
      assert.ok(Math.abs(moved.zoom / zoomed.zoom - 1) < 0.02);
      assert.equal(moved.undo, before.undo);
    },
  );

  test(`${device}: the model stands up under a finger and turns`, { device }, async (world) => {
    const { studio, page, touch, picture } = world;
    await studio.open();
    const { body, place } = await characterOn(studio);
    await drawPart(world, touch, body, 1);
    await page.getByRole("radio", { name: "Inflate" }).tap();
    await studio.until("the model", (state) => state.mode === "inflate");
    await page.waitForTimeout(900);
    const front = readPng(await picture("front"));
    await touch.stroke(
      [
        [400, 450],
        [480, 450],
        [560, 440],
        [640, 430],
      ].map(place),
    );
    await studio.atRest();
    assert.ok(countDifferent(front, readPng(await picture("turned"))) > 1000);
  });
}
