// SPDX-License-Identifier: Apache-2.0
// Mouse, fingers and pen, through the browser's own input. Points are [x, y] in px of the window.

/** How many moves may be under way at once: as dense as hardware that reports more often than the screen shows. */
const movesAtOnce = 4;

const inBetween = (from, to, share) => [
  from[0] + (to[0] - from[0]) * share,
  from[1] + (to[1] - from[1]) * share,
];

const masks = { left: 1, right: 2, middle: 4 };

/** Moves of one pointer; waits now and then, so that frames come in between. */
async function moveThrough(points, send) {
  let underWay = [];
  for (const point of points) {
    underWay.push(send(point));
    if (underWay.length === movesAtOnce) {
      await Promise.all(underWay);
      underWay = [];
    }
  }
  await Promise.all(underWay);
}

/** Mouse or pen: the browser tells them apart by one word. */
class Pointer {
  constructor(cdp, pointerType) {
    this.cdp = cdp;
    this.pointerType = pointerType;
  }

  send(type, [x, y], button, buttons, more) {
    const { pointerType } = this;
    return this.cdp.send("Input.dispatchMouseEvent", {
      type,
      x,
      y,
      button,
      buttons,
      pointerType,
      clickCount: type === "mouseMoved" ? 0 : 1,
      ...more,
    });
  }

  move(point) {
    return this.send("mouseMoved", point, "none", 0);
  }

  async press(point, { button = "left", modifiers = 0, force } = {}) {
    await this.move(point);
    await this.send("mousePressed", point, button, masks[button], { modifiers, force });
  }

  release(point, { button = "left", modifiers = 0 } = {}) {
    return this.send("mouseReleased", point, button, 0, { modifiers });
  }

  /** @param {object} options button; modifiers: 1 Alt, 2 Ctrl, 4 Meta, 8 Shift; force: share of the way -> 0 .. 1 */
  async stroke(points, { button = "left", modifiers = 0, force = () => undefined } = {}) {
    await this.press(points[0], { button, modifiers, force: force(0) });
    let index = 0;
    await moveThrough(points.slice(1), (point) => {
      const pressure = force(++index / points.length);
      return this.send("mouseMoved", point, button, masks[button], { modifiers, force: pressure });
    });
    await this.release(points.at(-1), { button, modifiers });
  }

  async strokes(lines, options) {
    for (const points of lines) await this.stroke(points, options);
  }

  /** A straight line in so many steps. */
  drag(from, to, { steps = 12, ...options } = {}) {
    const points = Array.from({ length: steps + 1 }, (_, k) => inBetween(from, to, k / steps));
    return this.stroke(points, options);
  }

  async click(point, options = {}) {
    await this.press(point, options);
    await this.release(point, options);
  }

  async doubleClick(point) {
    await this.click(point);
    await this.send("mousePressed", point, "left", 1, { clickCount: 2 });
    await this.send("mouseReleased", point, "left", 0, { clickCount: 2 });
  }
}

/** What fingers do together counts by its time; so it is told with the events, however slow the machine is. */
class Fingers {
  constructor(cdp) {
    this.cdp = cdp;
  }

  send(type, points, timestamp = Date.now() / 1000) {
    const touchPoints = points.map(([x, y], id) => ({ x, y, id, radiusX: 8, radiusY: 8 }));
    return this.cdp.send("Input.dispatchTouchEvent", { type, touchPoints, timestamp });
  }

  async stroke(points) {
    await this.send("touchStart", [points[0]]);
    await moveThrough(points.slice(1), (point) => this.send("touchMove", [point]));
    await this.send("touchEnd", []);
  }

  async strokes(lines) {
    for (const points of lines) await this.stroke(points);
  }

  /** Two fingers from their places to others. */
  async pinch([a, b], [toA, toB], steps = 12) {
    const start = Date.now() / 1000;
    await this.send("touchStart", [a, b], start);
    for (let k = 1; k <= steps; ++k) {
      const places = [inBetween(a, toA, k / steps), inBetween(b, toB, k / steps)];
      await this.send("touchMove", places, start + 0.03 * k);
    }
    await this.send("touchEnd", [], start + 0.03 * (steps + 1));
  }

  /** One tap of as many fingers as there are points. */
  async tap(...points) {
    const start = Date.now() / 1000;
    await this.send("touchStart", points, start);
    await this.send("touchEnd", [], start + 0.08);
  }
}

/** Runs in the page: from now on the pen is held the other way round. The browser's own protocol has no word for that. */
function turnPen(isTurned) {
  const types = ["pointerdown", "pointermove", "pointerup"];
  const turn = (event) => {
    if (event.pointerType !== "pen") return;
    Object.defineProperty(event, "buttons", { value: event.buttons === 0 ? 0 : 32 });
    Object.defineProperty(event, "button", { value: event.button === 0 ? 5 : event.button });
  };
  globalThis.inkflateTurn ??= turn;
  for (const type of types) {
    if (isTurned) globalThis.addEventListener(type, globalThis.inkflateTurn, true);
    else globalThis.removeEventListener(type, globalThis.inkflateTurn, true);
  }
}

/** @param {import("playwright-core").Page} page */
export async function handsOn(page) {
  const cdp = await page.context().newCDPSession(page);
  const pen = new Pointer(cdp, "pen");
  pen.turn = (isTurned) => page.evaluate(turnPen, isTurned);
  return {
    cdp,
    mouse: new Pointer(cdp, "mouse"),
    touch: new Fingers(cdp),
    pen,
    keys: page.keyboard,
  };
}
