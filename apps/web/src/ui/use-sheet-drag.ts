// SPDX-License-Identifier: Apache-2.0
import { useRef, useState } from "preact/hooks";
import { sheetAfterDrag, type SheetHeight } from "./sheet-drag";

interface Drag {
  readonly id: number;
  readonly startY: number;
  readonly lastY: number;
  readonly lastMs: number;
  /** px per ms, down positive. */
  readonly speed: number;
}

/** Of how fast a finger is, this much is told by its last move; the rest by those before. */
const speedMemory = 0.6;

/** Lets a handle slide a sheet up and down; the close button and Esc are the other ways. */
export function useSheetDrag(onClose: () => void) {
  const [height, setHeight] = useState<SheetHeight>("short");
  const [movedPx, setMovedPx] = useState(0);
  const drag = useRef<Drag | null>(null);

  const onPointerDown = (event: PointerEvent) => {
    if (!(event.currentTarget instanceof Element)) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const { pointerId: id, clientY, timeStamp } = event;
    drag.current = { id, startY: clientY, lastY: clientY, lastMs: timeStamp, speed: 0 };
  };

  const onPointerMove = (event: PointerEvent) => {
    const before = drag.current;
    if (before?.id !== event.pointerId) return;
    const passedMs = Math.max(1, event.timeStamp - before.lastMs);
    const now = (event.clientY - before.lastY) / passedMs;
    drag.current = {
      ...before,
      lastY: event.clientY,
      lastMs: event.timeStamp,
      speed: speedMemory * now + (1 - speedMemory) * before.speed,
    };
    setMovedPx(event.clientY - before.startY);
  };

  const onPointerUp = (event: PointerEvent) => {
    const before = drag.current;
    if (before?.id !== event.pointerId) return;
    drag.current = null;
    setMovedPx(0);
    const next = sheetAfterDrag(height, event.clientY - before.startY, before.speed);
    if (next === "closed") onClose();
    else setHeight(next);
  };

  const onPointerCancel = () => {
    drag.current = null;
    setMovedPx(0);
  };

  return {
    height,
    movedPx,
    isDragged: drag.current !== null,
    handle: { onPointerDown, onPointerMove, onPointerUp, onPointerCancel },
  };
}
