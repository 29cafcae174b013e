// SPDX-License-Identifier: Apache-2.0

/** How large an element is, and how many pixels of the device there are for one of CSS. */
export class ViewSize {
  width = 0;
  height = 0;
  pixelRatio = 1;
  private readonly observer: ResizeObserver;
  private readonly ending = new AbortController();

  /** Tells the first size too. */
  constructor(
    private readonly element: HTMLElement,
    private readonly tell: () => void,
  ) {
    this.observer = new ResizeObserver(() => {
      this.measure();
    });
    this.observer.observe(element);
    this.watchRatio();
  }

  dispose(): void {
    this.observer.disconnect();
    this.ending.abort();
  }

  /** A query fits one ratio only: at each change the next is asked. */
  private watchRatio(): void {
    const query = window.matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    const options = { once: true, signal: this.ending.signal };
    query.addEventListener(
      "change",
      () => {
        this.measure();
        this.watchRatio();
      },
      options,
    );
  }

  private measure(): void {
    const { clientWidth, clientHeight } = this.element;
    const { devicePixelRatio } = window;
    const isSame =
      clientWidth === this.width &&
      clientHeight === this.height &&
      devicePixelRatio === this.pixelRatio;
    if (isSame) return;
    this.width = clientWidth;
    this.height = clientHeight;
    this.pixelRatio = devicePixelRatio;
    this.tell();
  }
}
