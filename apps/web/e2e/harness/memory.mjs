// SPDX-License-Identifier: Apache-2.0
// How much memory a page and its workers hold, after all garbage has gone.

import { readFileSync } from "node:fs";

const mega = (bytes) => bytes / 1024 / 1024;

/** Speaks with the workers of a page, which have their own ends of the browser's protocol. */
class Workers {
  #sessions = new Set();
  #waiting = new Map();
  #number = 0;

  constructor(cdp) {
    this.cdp = cdp;
    // The service worker is no part of the page, and may sleep: then it never answers.
    cdp.on("Target.attachedToTarget", ({ sessionId, targetInfo }) => {
      if (targetInfo.type === "worker") this.#sessions.add(sessionId);
    });
    cdp.on("Target.detachedFromTarget", ({ sessionId }) => this.#sessions.delete(sessionId));
    cdp.on("Target.receivedMessageFromTarget", ({ message }) => {
      const { id, result } = JSON.parse(message);
      this.#waiting.get(id)?.(result);
    });
  }

  async attach() {
    const wanted = { autoAttach: true, waitForDebuggerOnStart: false, flatten: false };
    await this.cdp.send("Target.setAutoAttach", wanted);
  }

  get all() {
    return [...this.#sessions];
  }

  ask(sessionId, method, params = {}) {
    const id = ++this.#number;
    const answer = new Promise((resolve) => this.#waiting.set(id, resolve));
    const message = JSON.stringify({ id, method, params });
    return this.cdp.send("Target.sendMessageToTarget", { sessionId, message }).then(() => answer);
  }
}

/** What the processes that show pages hold for themselves: all of WebAssembly, bitmaps and textures too. NaN where there is no /proc. */
async function processBytes(browser) {
  const cdp = await browser.newBrowserCDPSession();
  const { processInfo } = await cdp.send("SystemInfo.getProcessInfo");
  await cdp.detach();
  return processInfo
    .filter(({ type }) => type === "renderer" || type === "GPU")
    .reduce((sum, { id }) => sum + ownBytes(id), 0);
}

function ownBytes(process) {
  try {
    const status = readFileSync(`/proc/${process}/status`, "utf8");
    return 1024 * Number(/RssAnon:\s+([0-9]+)/.exec(status)?.[1]);
  } catch {
    return NaN;
  }
}

/** Objects of scripts, and what hangs on them: nodes of the page, buffers. */
const held = ({ usedSize, embedderHeapUsedSize, backingStorageSize }) =>
  mega(usedSize + embedderHeapUsedSize + backingStorageSize);

export async function memoryOf(page) {
  const cdp = await page.context().newCDPSession(page);
  const workers = new Workers(cdp);
  await workers.attach();
  await page.waitForTimeout(200);
  await cdp.send("HeapProfiler.collectGarbage");
  const found = {
    pageMB: held(await cdp.send("Runtime.getHeapUsage")),
    workerMB: 0,
    processesMB: 0,
  };
  for (const session of workers.all) {
    await workers.ask(session, "HeapProfiler.collectGarbage");
    found.workerMB += held(await workers.ask(session, "Runtime.getHeapUsage"));
  }
  await cdp.detach();
  found.processesMB = mega(await processBytes(page.context().browser()));
  return found;
}
