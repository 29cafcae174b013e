// SPDX-License-Identifier: Apache-2.0
// Steps that several flows take, as a person would: with a hand on the sheet and keys.
import { placedIn, roughCharacter } from "./shapes.mjs";

/** The rough character of the tests, where it lies in this window. */
export async function characterOn(studio, seed = 1) {
  const place = placedIn(await studio.sheet());
  const { body, head, nearArm, farArm } = roughCharacter(seed);
  const placed = (strokes) => strokes.map((points) => points.map(place));
  const arm = ({ strokes, helpLine }) => ({
    strokes: placed(strokes),
    helpLine: helpLine.map(place),
  });
  return { place, body: placed(body), head: placed(head), near: arm(nearArm), far: arm(farArm) };
}

/** Draws a closed part and simplifies it. */
export async function drawPart({ studio, keys }, hand, strokes, count) {
  await hand.strokes(strokes);
  await studio.until("loose strokes", (state) => state.hasRoughStrokes);
  await keys.press("Enter");
  return studio.partsAre(count);
}

/** Draws an arm, closes its shoulder with a help line, and simplifies it. */
export async function drawArm({ studio, keys }, hand, arm, count) {
  await hand.strokes(arm.strokes);
  await keys.press("l");
  await studio.until("help line", (state) => state.tool === "help_line");
  await hand.stroke(arm.helpLine);
  await keys.press("b");
  await keys.press("Enter");
  return studio.partsAre(count);
}

/** Body, head and both arms. */
export async function drawCharacter(world, hand, seed) {
  const character = await characterOn(world.studio, seed);
  await drawPart(world, hand, character.body, 1);
  await drawPart(world, hand, character.head, 2);
  await drawArm(world, hand, character.near, 3);
  await drawArm(world, hand, character.far, 4);
  return character;
}

/** Goes to the model, and waits until it stands. */
export async function inflate({ studio, page, keys }) {
  await keys.press("2");
  await studio.until("the model", (state) => state.mode === "inflate" && !state.isWorking);
  await page.waitForTimeout(900);
}
