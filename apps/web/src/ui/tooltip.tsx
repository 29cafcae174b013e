// SPDX-License-Identifier: Apache-2.0
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import "../styles/tooltip.css";

/** The hand rests this long before the first one comes; the next ones come at once. */
const restMs = 450;
/** How long after one the next comes at once. */
const warmMs = 400;
const distancePx = 8;
/** From the window's edge. */
const marginPx = 6;

type Side = "right" | "bottom" | "top";

function isSide(text: string | undefined): text is Side {
  return text === "right" || text === "bottom" || text === "top";
}

function sideOf(target: HTMLElement): Side {
  const side = target.closest<HTMLElement>("[data-tip-side]")?.dataset.tipSide;
  if (!isSide(side)) return "bottom";
  // A column that lies down as a bar at the window's foot tells upwards.
  const box = target.getBoundingClientRect();
  return side === "right" && box.bottom > window.innerHeight - 80 ? "top" : side;
}

function clamped(value: number, least: number, most: number): number {
  return Math.max(least, Math.min(value, most));
}

function place(tip: HTMLElement, target: HTMLElement): void {
  const box = target.getBoundingClientRect();
  const { offsetWidth: width, offsetHeight: height } = tip;
  const side = sideOf(target);
  const middle = box.left + (box.width - width) / 2;
  const left = side === "right" ? box.right + distancePx : middle;
  const top =
    side === "right"
      ? box.top + (box.height - height) / 2
      : side === "top"
        ? box.top - height - distancePx
        : box.bottom + distancePx;
  const most = window.innerWidth - width - marginPx;
  tip.style.left = `${clamped(left, marginPx, most)}px`;
  tip.style.top = `${clamped(top, marginPx, window.innerHeight - height - marginPx)}px`;
}

function tippedAt(target: EventTarget | null): HTMLElement | null {
  return target instanceof Element ? target.closest<HTMLElement>("[data-tip]") : null;
}

/** What the pointer rests on, or the focus has been moved to by keys. */
function useTipped(): HTMLElement | null {
  const [tipped, setTipped] = useState<HTMLElement | null>(null);
  useEffect(() => {
    const stop = new AbortController();
    const options = { signal: stop.signal, capture: true };
    let timer = 0;
    let lastMs = -Infinity;
    const hide = () => {
      clearTimeout(timer);
      setTipped((before) => {
        if (before !== null) lastMs = performance.now();
        return null;
      });
    };
    const show = (target: HTMLElement, waitMs: number) => {
      clearTimeout(timer);
      timer = window.setTimeout(() => {
        setTipped(target);
      }, waitMs);
    };
    const onOver = (event: PointerEvent) => {
      const target = event.pointerType === "touch" ? null : tippedAt(event.target);
      hide();
      if (target !== null) show(target, performance.now() - lastMs < warmMs ? 0 : restMs);
    };
    const onFocus = (event: FocusEvent) => {
      const target = tippedAt(event.target);
      if (target?.matches(":focus-visible") === true) show(target, 0);
    };
    document.addEventListener("pointerover", onOver, options);
    document.addEventListener("pointerdown", hide, options);
    document.addEventListener("focusin", onFocus, options);
    document.addEventListener("focusout", hide, options);
    document.addEventListener("keydown", hide, options);
    document.documentElement.addEventListener("pointerleave", hide, { signal: stop.signal });
    return () => {
      clearTimeout(timer);
      stop.abort();
    };
  }, []);
  return tipped;
}

/**
 * The one tooltip of the page: the name and key of what has data-tip. Names are the elements' own, so it is not read out again.
 */
export function Tooltip() {
  const tipped = useTipped();
  const frame = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (frame.current !== null && tipped !== null) place(frame.current, tipped);
  }, [tipped]);
  if (tipped?.isConnected !== true) return null;
  const chord = tipped.dataset.tipChord ?? "";
  return (
    <div class="tooltip" ref={frame} aria-hidden="true">
      {tipped.dataset.tip}
      {chord !== "" && <kbd>{chord}</kbd>}
    </div>
  );
}
