// SPDX-License-Identifier: Apache-2.0
// What is said around the paper while one bends, and what can be set there.
import assert from "node:assert/strict";
import { withArm, withBar } from "../harness/bendable.mjs";
import { characterOn } from "../harness/drawn.mjs";
import { test } from "../harness/tests.mjs";

for (const device of ["wide", "phone"]) {
  test(`${device}: what is said does not lie over open settings`, { device }, async (world) => {
    const { studio, page, mouse, touch } = world;
    await withBar(world, device === "phone" ? touch : mouse);
    await page.getByRole("button", { name: "More about bending" }).click();
    await studio.act("next_pin");
    await page.locator(".notice").first().waitFor();
    const [said, open] = await Promise.all(
      [".notices", ".popover-content"].map((each) => page.locator(each).boundingBox()),
    );
    const isApart =
      said.y + said.height <= open.y ||
      open.y + open.height <= said.y ||
      said.x + said.width <= open.x ||
      open.x + open.width <= said.x;
    assert.ok(isApart, JSON.stringify({ said, open }));
  });
}

test("a sketch is to be simplified before it is bent", {}, async (world) => {
  const { studio, page, mouse, keys } = world;
  await studio.open();
  const { place } = await characterOn(studio);
  const hint = page.getByRole("complementary", { name: "Hints" });
  await mouse.drag(place([300, 300]), place([600, 300]));
  await studio.until("drawn", (state) => state.hasRoughStrokes);
  await keys.press("d");
  await hint.getByText("Simplify first").waitFor();
  assert.equal(await hint.count(), 1);
  await mouse.drag(place([450, 300]), place([450, 420]));
  await studio.until("bent", (state) => state.undo === "deform");
  await hint.getByText("Simplify first").waitFor();
});

test("Deform speaks of itself alone, and the way on waits", {}, async (world) => {
  const { page, mouse, keys } = world;
  const place = await withBar(world, mouse);
  const hint = page.getByRole("complementary", { name: "Hints" });
  await hint.getByText("Drag a line").waitFor();
  assert.equal(await hint.count(), 1);
  await mouse.drag(place([500, 200]), place([700, 230]), { steps: 12 });
  await hint.waitFor({ state: "detached" });
  await keys.press("b");
  await hint.getByText("to inflate it").waitFor();
});

test("of several parts none is pinned, and that is said", {}, async (world) => {
  const { studio, mouse, keys } = world;
  await withArm(world, mouse);
  await keys.press("Control+a");
  await studio.until("selected", ({ layers }) => layers.every((each) => each.isSelected));
  await keys.press("Shift+D");
  const { pins } = await studio.until("it is said", ({ notices }) =>
    notices.some(({ text }) => text === "Several parts are selected: select just one."),
  );
  assert.equal(pins, 0);
});

test("the bar says how it bends, and does it", {}, async (world) => {
  const { studio, page, mouse, keys, picture } = world;
  const place = await withBar(world, mouse);
  const body = page.getByRole("slider", { name: "Stiffness of the body" });
  assert.equal(await body.getAttribute("aria-valuetext"), "Body");
  await body.focus();
  await keys.press("Home");
  await studio.until("wire", (state) => state.bendBody === 0.003);
  assert.equal(await body.getAttribute("aria-valuetext"), "Wire");
  const reach = page.getByRole("slider", { name: "Reach" });
  const auto = page.getByRole("button", { name: "Auto" });
  // What Auto means now, and no more than that is said when it ends.
  await auto.click();
  await studio.until("what was meant", (state) => state.bendReach === 0.6);
  assert.equal(await reach.getAttribute("aria-valuetext"), "60 %");
  await auto.click();
  await mouse.click(place([500, 700]));
  await studio.until("held by a pin", (state) => state.usualReach === 1);
  assert.equal(await reach.getAttribute("aria-valuetext"), "Whole part");
  await studio.act("delete_pins");
  await studio.until("held by nothing", (state) => state.usualReach === 0.6);
  await reach.focus();
  await keys.press("End");
  await studio.until("all of it", (state) => state.bendReach === 1);
  assert.equal(await auto.getAttribute("aria-pressed"), "false");
  await auto.click();
  await studio.until("automatic", (state) => state.bendReach === null);
  await page.getByRole("button", { name: "More about bending" }).click();
  await picture("more");
  await page.getByRole("switch", { name: "As a wire strip" }).click();
  await studio.until("a strip", (state) => state.bendMode === "wire");
  await mouse.click(place([900, 700]));
  await mouse.drag(place([580, 450]), place([680, 450]), { steps: 12 });
  await studio.until("bent", (state) => state.undo === "deform");
});
