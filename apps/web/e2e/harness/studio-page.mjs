// SPDX-License-Identifier: Apache-2.0
// One open studio as a test sees it. What a person can see is read from the page; the rest through `inkflateStudio`, which the page
// lays open when its address ends with #test.
import assert from "node:assert/strict";
import { setTimeout as sleep } from "node:timers/promises";

/** How long a person would wait before giving up; machines that build beside the tests are slow. */
const patienceMs = 30000;

/** Runs in the page: what tests need to know of the studio, as plain values. */
function readStudio() {
  const studio = globalThis.inkflateStudio;
  if (studio === undefined) return null;
  return {
    ...studio.state.value,
    isStarting: studio.isStarting.value,
    isWorking: studio.longWork.value !== null,
    saveState: studio.saveState.value,
    notices: studio.notices.value.map(({ severity, text }) => ({ severity, text })),
    panel: studio.panel.value,
  };
}

/** Runs in the page. What hands do goes to the core with the next picture at the latest. */
async function isAtRest() {
  const nextPicture = () => new Promise((resolve) => requestAnimationFrame(resolve));
  await nextPicture();
  await nextPicture();
  return globalThis.inkflateStudio.isAtRest();
}

export class StudioPage {
  constructor(page, origin) {
    this.page = page;
    this.origin = origin;
  }

  /** Opens the studio and waits until it can be drawn in. */
  async open(path = "/#test") {
    await this.page.goto(this.origin + path);
    await this.until("the studio is ready", (state) => !state.isStarting);
  }

  state() {
    return this.page.evaluate(readStudio);
  }

  /** Waits until this holds of the state; what holds then. */
  async until(what, holds, timeoutMs = patienceMs) {
    const end = Date.now() + timeoutMs;
    let state = null;
    do {
      state = await this.state();
      if (state !== null && holds(state)) return state;
      await sleep(60);
    } while (Date.now() < end);
    return assert.fail(`never: ${what}; at the end ${JSON.stringify(state)}`);
  }

  partsAre(count) {
    return this.until(`${count} parts`, (state) => state.layers.length === count);
  }

  /** Waits until all that hands have done shows, and nothing moves by itself; how things stand then. */
  async atRest() {
    const end = Date.now() + patienceMs;
    while (!(await this.page.evaluate(isAtRest))) {
      if (Date.now() > end) assert.fail("the core never comes to rest");
      await sleep(20);
    }
    return this.state();
  }

  /** Waits until the last change has been kept on this device. */
  saved() {
    return this.until("saved", (state) => state.saveState.kind === "saved");
  }

  /** As a menu or button would: by the name of docs/ACTIONS.md. */
  act(name, argument = "") {
    return this.page.evaluate(
      ([each, value]) => globalThis.inkflateStudio.act(each, value),
      [name, argument],
    );
  }

  /** Opens a file as if it had been chosen. */
  openFile(name, bytes, use = "open") {
    const base64 = Buffer.from(bytes).toString("base64");
    return this.page.evaluate(
      ([fileName, content, wanted]) => {
        const data = Uint8Array.from(atob(content), (sign) => sign.charCodeAt(0));
        globalThis.inkflateStudio.open(new File([data], fileName), wanted);
      },
      [name, base64, use],
    );
  }

  /** The drawing in one of the formats that the core writes, without the page's dialogs. */
  async written(extension) {
    const base64 = await this.page.evaluate(async (wanted) => {
      const [file] = await globalThis.inkflateStudio.exportAs(wanted);
      return btoa(Array.from(file.bytes, (byte) => String.fromCharCode(byte)).join(""));
    }, extension);
    return Buffer.from(base64, "base64");
  }

  /** Where the hand can draw without touching what floats at the edges. */
  async sheet() {
    const { width, height } = this.page.viewportSize();
    const isNarrow = width < 900;
    const [left, top, right, bottom] = isNarrow ? [16, 72, 16, 190] : [110, 80, 300, 110];
    return { x: left, y: top, width: width - left - right, height: height - top - bottom };
  }

  button(name) {
    return this.page.getByRole("button", { name });
  }

  /** The bytes of a file that is offered for saving while `doing` goes on. */
  async download(doing) {
    const offered = this.page.waitForEvent("download", { timeout: patienceMs });
    const [file] = await Promise.all([offered, doing()]);
    const chunks = [];
    for await (const chunk of await file.createReadStream()) chunks.push(chunk);
    return { name: file.suggestedFilename(), bytes: Buffer.concat(chunks) };
  }
}
