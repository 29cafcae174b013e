// SPDX-License-Identifier: Apache-2.0
import { cursorLook, type CursorSetting } from "./cursor-look";
import type { ScreenPoint } from "./places";

/** How long a size that has changed is shown as a number, ms. */
const sizeShownMs = 900;

/** The ring that shows how large the brush or the eraser is, and its size in words when it changes. */
export class Cursor {
  readonly element = document.createElement("div");
  private readonly ring = document.createElement("div");
  private readonly size = document.createElement("div");
  private place: ScreenPoint | null = null;
  private ringPx: number | null = null;
  private sizeText = "";
  private timer = 0;

  /** view: the element whose pointer it is. */
  constructor(private readonly view: HTMLElement) {
    this.element.className = "stage-cursor";
    this.element.ariaHidden = "true";
    this.ring.className = "stage-cursor-ring";
    this.size.className = "stage-cursor-size";
    this.element.append(this.ring, this.size);
    this.follow();
  }

  set(setting: CursorSetting): void {
    const { system, ringPx } = cursorLook(setting);
    this.view.style.cursor = system;
    this.ringPx = ringPx;
    const { tool, brushPx, eraserPx } = setting.state;
    const px = tool === "eraser" ? 2 * eraserPx : brushPx;
    const text = `${tool} ${px}`;
    const isSameTool = this.sizeText.startsWith(`${tool} `);
    if (ringPx !== null && isSameTool && text !== this.sizeText) this.showSize(px);
    this.sizeText = text;
    this.follow();
  }

  /** null: the pointer is elsewhere, or a finger. */
  moveTo(place: ScreenPoint | null): void {
    this.place = place;
    this.follow();
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.element.remove();
  }

  private showSize(px: number): void {
    clearTimeout(this.timer);
    this.size.textContent = `${Math.round(px * 10) / 10} px`;
    this.element.classList.add("is-size-shown");
    this.timer = window.setTimeout(() => {
      this.element.classList.remove("is-size-shown");
      this.follow();
    }, sizeShownMs);
  }

  /** While its size is shown the ring is in the middle of the view when no pointer is over it. */
  private follow(): void {
    const isSizeShown = this.element.classList.contains("is-size-shown");
    const { clientWidth, clientHeight } = this.view;
    const middle: ScreenPoint = [clientWidth / 2, clientHeight / 2];
    const place = this.place ?? (isSizeShown ? middle : null);
    this.element.hidden = place === null || this.ringPx === null;
    if (place === null || this.ringPx === null) return;
    const side = `${this.ringPx}px`;
    this.element.style.transform = `translate(${place[0]}px, ${place[1]}px)`;
    this.ring.style.width = side;
    this.ring.style.height = side;
    this.size.style.left = `${this.ringPx / 2}px`;
  }
}
