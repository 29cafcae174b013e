// SPDX-License-Identifier: Apache-2.0
import type { Address, CoreExports } from "#core";
import {
  fileUses,
  pointerActions,
  pointerButtons,
  pointerKinds,
  type CoreEvent,
  type Modifiers,
  type PointerInput,
} from "../protocol/events";
import type { CoreMemory } from "./core-memory";

/** As bindings/core.cpp reads them. */
function modifierBits(modifiers: Modifiers): number {
  return Number(modifiers.isShift) + 2 * Number(modifiers.isCtrl) + 4 * Number(modifiers.isAlt);
}

function sendPointer(core: CoreExports, engine: Address, event: PointerInput): void {
  core._engine_pointer(
    engine,
    pointerActions.indexOf(event.action),
    pointerKinds.indexOf(event.kind),
    event.id,
    pointerButtons.indexOf(event.button),
    event.x,
    event.y,
    event.pressure,
    event.timeS,
    modifierBits(event.modifiers),
  );
}

/** Hands an event to an engine, as plain numbers. */
export function sendEvent(
  core: CoreExports,
  memory: CoreMemory,
  engine: Address,
  event: CoreEvent,
): void {
  switch (event.type) {
    case "pointer":
      sendPointer(core, engine, event);
      return;
    case "key":
      memory.with([event.key], (key) => {
        const isPress = Number(event.isPress);
        const isRepeat = Number(event.isRepeat);
        const bits = modifierBits(event.modifiers);
        core._engine_key(engine, key.address, key.bytes, isPress, isRepeat, event.timeS, bits);
      });
      return;
    case "wheel": {
      const { x, y, deltaX, deltaY, modifiers } = event;
      core._engine_wheel(engine, x, y, deltaX, deltaY, modifierBits(modifiers));
      return;
    }
    case "gesture":
      core._engine_gesture(engine, event.x, event.y, event.scale, event.movedX, event.movedY);
      return;
    case "action":
      memory.with([event.name, event.argument], (name, argument) => {
        core._engine_action(engine, name.address, name.bytes, argument.address, argument.bytes);
      });
      return;
    case "file":
      memory.with([event.bytes, event.name], (bytes, name) => {
        const use = fileUses.indexOf(event.use);
        core._engine_file(engine, bytes.address, bytes.bytes, name.address, name.bytes, use);
      });
      return;
    case "resize": {
      const { left, top, right, bottom } = event.edges;
      core._engine_resize(engine, event.width, event.height, left, top, right, bottom);
    }
  }
}
