// SPDX-License-Identifier: Apache-2.0

/** A tap may slip so far, px. */
const slipPx = 5;

/** The paper under a place of the window; null: there is none. */
function paperAt(x: number, y: number): Element | null {
  const under = document.elementsFromPoint(x, y);
  return under.find((element) => element.classList.contains("stage")) ?? null;
}

/** The paper gets the press as it was, and all that this pointer does from now on. */
function handOver(press: PointerEvent): void {
  const paper = paperAt(press.clientX, press.clientY);
  if (paper === null) return;
  paper.dispatchEvent(new PointerEvent("pointerdown", press));
  paper.setPointerCapture(press.pointerId);
}

/** For what lies on the paper and can be tapped: a press that moves on is a stroke, and begins where it was pressed. */
export function drawThrough(press: PointerEvent): void {
  const over = new AbortController();
  const isSame = (event: PointerEvent) => event.pointerId === press.pointerId;
  const onMove = (event: PointerEvent) => {
    const way = Math.hypot(event.clientX - press.clientX, event.clientY - press.clientY);
    if (!isSame(event) || way <= slipPx) return;
    over.abort();
    handOver(press);
  };
  const onEnd = (event: PointerEvent) => {
    if (isSame(event)) over.abort();
  };
  const options = { signal: over.signal, capture: true };
  window.addEventListener("pointermove", onMove, options);
  window.addEventListener("pointerup", onEnd, options);
  window.addEventListener("pointercancel", onEnd, options);
}
