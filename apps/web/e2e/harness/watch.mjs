// SPDX-License-Identifier: Apache-2.0
// Sees what no person would: requests to elsewhere, breaches of the content security policy, errors.
import { setTimeout as sleep } from "node:timers/promises";

/** Runs in each page before its own scripts. */
function reportBreaches() {
  document.addEventListener("securitypolicyviolation", (breach) => {
    globalThis.inkflateBreach(`${breach.effectiveDirective} stopped ${breach.blockedURI}`);
  });
}

/** Faults of one browser context, each with the kind that the summary counts. */
export class Watch {
  faults = [];

  constructor(origin, expected = []) {
    this.origin = origin;
    this.expected = expected;
  }

  add(kind, text) {
    if (!this.expected.some((pattern) => pattern.test(text))) this.faults.push({ kind, text });
  }

  /** The faults of this kind, once there are any. */
  async until(kind, timeoutMs = 30000) {
    const end = Date.now() + timeoutMs;
    for (;;) {
      const found = this.faults.filter((fault) => fault.kind === kind);
      if (found.length > 0 || Date.now() > end) return found;
      await sleep(50);
    }
  }

  /** Forgets the faults that a test has planted, and those that follow from them: a browser tells of one breach in several ways. */
  async forget() {
    await sleep(1000);
    this.faults.length = 0;
  }

  #seeRequest(url) {
    const { protocol, origin } = new URL(url);
    if (["data:", "blob:", "about:"].includes(protocol) || origin === this.origin) return;
    this.add("foreign request", url);
  }

  #seeConsole(message) {
    if (message.type() !== "error") return;
    const isBreach = message.text().includes("Content Security Policy");
    this.add(isBreach ? "policy breach" : "console error", message.text());
  }

  async attach(context) {
    await context.exposeFunction("inkflateBreach", (text) => this.add("policy breach", text));
    await context.addInitScript(reportBreaches);
    context.on("request", (request) => this.#seeRequest(request.url()));
    context.on("console", (message) => this.#seeConsole(message));
    context.on("weberror", (found) => this.add("page error", String(found.error().stack)));
  }
}
