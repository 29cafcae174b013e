// SPDX-License-Identifier: Apache-2.0
import type { RefObject } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { gapAt } from "./part-order";

/** A press that moves less is a click. */
const startsAfterPx = 5;
/** Near its ends the list scrolls along. */
const scrollZonePx = 28;
const scrollStepPx = 8;

interface PartDrag {
  readonly from: number;
  readonly startY: number;
  readonly pointer: number;
}

export interface ShownDrag {
  readonly from: number;
  readonly gap: number;
}

function rowMiddles(list: HTMLElement): number[] {
  return [...list.querySelectorAll("[data-part]")].map((row) => {
    const box = row.getBoundingClientRect();
    return box.top + box.height / 2;
  });
}

function scrollAlong(list: HTMLElement, y: number): void {
  const box = list.getBoundingClientRect();
  if (y < box.top + scrollZonePx) list.scrollBy({ top: -scrollStepPx });
  if (y > box.bottom - scrollZonePx) list.scrollBy({ top: scrollStepPx });
}

/** Rows of a list that are dragged to another gap. Esc drops the drag. */
export function usePartDrag(
  list: RefObject<HTMLElement>,
  onDrop: (from: number, gap: number) => void,
) {
  const drag = useRef<PartDrag | null>(null);
  const [shown, setShown] = useState<ShownDrag | null>(null);
  const wasDragged = useRef(false);

  const drop = () => {
    drag.current = null;
    setShown(null);
  };

  useEffect(() => {
    if (shown === null) return;
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      event.preventDefault();
      drop();
    };
    addEventListener("keydown", onKey, { capture: true });
    return () => {
      removeEventListener("keydown", onKey, { capture: true });
    };
  }, [shown]);

  /** isHandle: fingers scroll the list unless they are on the handle. */
  const onPointerDown = (event: PointerEvent, from: number, isHandle: boolean) => {
    wasDragged.current = false;
    if (event.button !== 0 || (!isHandle && event.pointerType !== "mouse")) return;
    drag.current = { from, startY: event.clientY, pointer: event.pointerId };
  };

  const onPointerMove = (event: PointerEvent) => {
    const held = drag.current;
    if (held?.pointer !== event.pointerId || list.current === null) return;
    if (shown === null) {
      if (Math.abs(event.clientY - held.startY) < startsAfterPx) return;
      list.current.setPointerCapture(event.pointerId);
      wasDragged.current = true;
    }
    scrollAlong(list.current, event.clientY);
    setShown({ from: held.from, gap: gapAt(rowMiddles(list.current), event.clientY) });
  };

  const onPointerUp = () => {
    if (drag.current !== null && shown !== null) onDrop(shown.from, shown.gap);
    drop();
  };

  return {
    shown,
    /** The click that ends a drag selects nothing. */
    isClick: () => !wasDragged.current,
    onPointerDown,
    listeners: { onPointerMove, onPointerUp, onPointerCancel: drop },
  };
}
