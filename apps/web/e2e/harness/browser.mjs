// SPDX-License-Identifier: Apache-2.0
import { chromium } from "playwright-core";

/** Debian's; another one by the environment. */
export const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";

export const flags = [
  "--no-sandbox",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

/** @param {string[]} more flags of one test file or of figures.mjs */
export function launch(more = []) {
  return chromium.launch({ executablePath, args: [...flags, ...more] });
}
