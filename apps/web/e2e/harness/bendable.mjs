// SPDX-License-Identifier: Apache-2.0
// What there is to bend, with the Deform tool in hand.
import { characterOn, drawArm, drawPart } from "./drawn.mjs";

/** The tool, and nothing on the paper but the drawing. */
export async function deform({ studio, keys }) {
  await studio.act("grid");
  await keys.press("d");
  return studio.until("the tool", (state) => state.tool === "deform");
}

/** A body with its near arm, and where the arm's hand is. */
export async function withArm(world, hand) {
  const { studio } = world;
  await studio.open();
  const character = await characterOn(studio);
  await drawPart(world, hand, character.body, 1);
  await drawArm(world, hand, character.near, 2);
  await deform(world);
  return { ...character, tip: character.place([897, 318]) };
}

/** One part alone: an upright bar. */
export async function withBar(world, hand) {
  const { studio } = world;
  await studio.open();
  const { place } = await characterOn(studio);
  const corners = [
    [420, 200],
    [580, 200],
    [580, 700],
    [420, 700],
    [420, 202],
  ];
  await drawPart(world, hand, [corners.map(place)], 1);
  await deform(world);
  return place;
}
