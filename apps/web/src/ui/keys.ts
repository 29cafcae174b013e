// SPDX-License-Identifier: Apache-2.0
import { computed } from "@preact/signals";
import { isApple as isAppleSystem } from "../studio/chords";
import type { Studio } from "../studio/studio";
import { coreKey, isCoreKey, isOwnKey, keysOf, type KeyOwner } from "./key-input";

const textTypes = /^(text|search|number|email|url|password|tel)$/;
const listRoles = "[role=menu], [role=listbox], [role=dialog], dialog";
const buttonRoles = "button, a[href], summary, select, [role=button], [role=radio]";

/** Who uses keys by itself, where the focus is. */
function ownerOf(target: EventTarget | null): KeyOwner {
  if (!(target instanceof HTMLElement)) return "none";
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return "text";
  if (target instanceof HTMLInputElement && textTypes.test(target.type)) return "text";
  if (target.closest(listRoles) !== null) return "list";
  if (target instanceof HTMLInputElement && target.type === "range") return "slider";
  return target instanceof HTMLInputElement || target.matches(buttonRoles) ? "button" : "none";
}

/** Keys of the whole page go to the core, after all that is open over the canvas. Returns how to stop. */
export function listenToKeys(studio: Studio): () => void {
  const keys = computed(() => keysOf(studio.actions.value));
  const paletteKeys = computed(() =>
    keysOf(studio.actions.value.filter(({ name }) => name === "palette")),
  );
  const isApple = isAppleSystem(navigator.platform);

  function tell(event: KeyboardEvent, isPress: boolean): void {
    studio.send({
      type: "key",
      key: coreKey(event, keys.value),
      isPress,
      isRepeat: event.repeat,
      timeS: event.timeStamp / 1000,
      modifiers: {
        isShift: event.shiftKey,
        isCtrl: isApple ? event.metaKey : event.ctrlKey,
        isAlt: event.altKey,
      },
    });
  }

  function onKeyDown(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.isComposing) return;
    if (isOwnKey(event, ownerOf(event.target))) return;
    // What is typed next is meant for its field: that must not wait until the core has asked for it.
    if (isCoreKey(event, isApple, paletteKeys.value)) {
      event.preventDefault();
      studio.panel.value = "palette";
      return;
    }
    // Space scrolls, and so do arrows; the table's keys with Ctrl are the browser's own.
    if (event.key === " " || isCoreKey(event, isApple, keys.value)) event.preventDefault();
    tell(event, true);
  }

  function onKeyUp(event: KeyboardEvent): void {
    if (event.key === " " || !isOwnKey(event, ownerOf(event.target))) tell(event, false);
  }

  /** A key that is let go over another window is never heard of. */
  function onBlur(): void {
    tell(new KeyboardEvent("keyup", { key: " " }), false);
  }

  window.addEventListener("keydown", onKeyDown);
  window.addEventListener("keyup", onKeyUp);
  window.addEventListener("blur", onBlur);
  return () => {
    window.removeEventListener("keydown", onKeyDown);
    window.removeEventListener("keyup", onKeyUp);
    window.removeEventListener("blur", onBlur);
  };
}
