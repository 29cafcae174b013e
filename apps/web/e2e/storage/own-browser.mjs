// SPDX-License-Identifier: Apache-2.0
// A browser of our own that can be killed, and opened again on what it has left on the disk.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { chromium } from "playwright-core";
import { executablePath, flags } from "../harness/browser.mjs";
import { StudioPage } from "../harness/studio-page.mjs";

/** @returns {Promise<string>} where it can be talked to */
async function addressOf(browser) {
  for await (const line of createInterface({ input: browser.stderr })) {
    const found = /DevTools listening on (\S+)/.exec(line);
    if (found) return found[1];
  }
  throw new Error("the browser has not started");
}

export class OwnBrowser {
  static async folder() {
    const path = await mkdtemp(join(tmpdir(), "inkflate-"));
    return { path, remove: () => rm(path, { recursive: true, force: true, maxRetries: 5 }) };
  }

  /** Starts it on the folder of an earlier one. */
  static async start(folder) {
    const own = [`--user-data-dir=${folder.path}`, "--remote-debugging-port=0", "--headless=new"];
    const process = spawn(executablePath, [...flags, ...own, "about:blank"], {
      detached: true,
      stdio: ["ignore", "ignore", "pipe"],
    });
    const driver = await chromium.connectOverCDP(await addressOf(process));
    process.stderr.resume();
    return new OwnBrowser(process, driver);
  }

  constructor(process, driver) {
    this.process = process;
    this.driver = driver;
  }

  /** A studio in a new tab, ready to be drawn in. */
  async studio(origin) {
    const page = await this.driver.contexts()[0].newPage();
    const studio = new StudioPage(page, origin);
    await studio.open();
    return studio;
  }

  /** At once, with all its processes; nothing can be put in order. */
  async kill() {
    if (this.process.exitCode !== null || this.process.signalCode !== null) return;
    const end = once(this.process, "exit");
    globalThis.process.kill(-this.process.pid, "SIGKILL");
    await end;
    await this.driver.close().catch(() => null);
  }
}
