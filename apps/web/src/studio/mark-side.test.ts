// SPDX-License-Identifier: Apache-2.0
import { expect, it } from "vitest";
import type { PointerInput } from "../protocol/events";
import { markedAs } from "./mark-side";

const click = (isAlt: boolean): PointerInput => ({
  type: "pointer",
  action: "press",
  kind: "touch",
  id: 1,
  button: "primary",
  x: 10,
  y: 20,
  pressure: 0.5,
  timeS: 1,
  modifiers: { isShift: false, isCtrl: false, isAlt },
});

it("leaves a click as it is while outside is chosen", () => {
  expect(markedAs("outside", click(false))).toEqual(click(false));
  expect(markedAs("outside", click(true))).toEqual(click(true));
});

it("makes Alt of the choice of inside, and takes it back from a hand that holds Alt", () => {
  expect(markedAs("inside", click(false))).toEqual(click(true));
  expect(markedAs("inside", click(true))).toEqual(click(false));
});
