// SPDX-License-Identifier: Apache-2.0
import { useLayoutEffect, useRef } from "preact/hooks";
import type { RefObject } from "preact";

export type Orientation = "horizontal" | "vertical" | "both";

const steps: Readonly<Record<string, readonly [Orientation, number]>> = {
  ArrowRight: ["horizontal", 1],
  ArrowLeft: ["horizontal", -1],
  ArrowDown: ["vertical", 1],
  ArrowUp: ["vertical", -1],
};

/** Where a key moves the focus among items in a row, round the ends; null: the key is none of a row's. */
export function nextIndex(
  key: string,
  index: number,
  count: number,
  orientation: Orientation,
): number | null {
  if (count === 0) return null;
  if (key === "Home") return 0;
  if (key === "End") return count - 1;
  const step = steps[key];
  if (step === undefined) return null;
  const [along, by] = step;
  if (orientation !== "both" && orientation !== along) return null;
  return (index + by + count) % count;
}

/** Those that the arrows go through; what is not shown is left out. */
function itemsOf(root: HTMLElement): HTMLElement[] {
  const all = [...root.querySelectorAll<HTMLElement>("[data-roving]")];
  return all.filter((item) => item.getClientRects().length > 0);
}

function isChosen(item: HTMLElement): boolean {
  return (
    item.getAttribute("aria-pressed") === "true" || item.getAttribute("aria-checked") === "true"
  );
}

/** One item takes part in the order of Tab: that with the focus, else the chosen one, else the first. */
function letOneIn(items: readonly HTMLElement[]): void {
  const entry =
    items.find((item) => item === document.activeElement) ?? items.find(isChosen) ?? items[0];
  for (const item of items) item.tabIndex = item === entry ? 0 : -1;
}

interface Roving<T extends HTMLElement> {
  readonly ref: RefObject<T>;
  readonly onKeyDown: (event: KeyboardEvent) => void;
  readonly onFocusIn: () => void;
}

/**
 * Arrows move the focus among the elements with data-roving inside of the one with ref.
 * select: the item that the focus reaches is chosen at once, as in a group of radio buttons.
 */
export function useRoving<T extends HTMLElement>(
  orientation: Orientation,
  select: (item: HTMLElement) => void = () => undefined,
): Roving<T> {
  const ref = useRef<T>(null);
  useLayoutEffect(() => {
    if (ref.current !== null) letOneIn(itemsOf(ref.current));
  });
  return {
    ref,
    onFocusIn() {
      if (ref.current !== null) letOneIn(itemsOf(ref.current));
    },
    onKeyDown(event) {
      const isModified = event.ctrlKey || event.metaKey || event.altKey || event.shiftKey;
      if (isModified || ref.current === null) return;
      const items = itemsOf(ref.current);
      const index = items.findIndex((item) => item === document.activeElement);
      const next = index < 0 ? null : nextIndex(event.key, index, items.length, orientation);
      const item = next === null ? undefined : items[next];
      if (item === undefined) return;
      event.preventDefault();
      item.focus();
      select(item);
    },
  };
}
