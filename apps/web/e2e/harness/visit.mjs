// SPDX-License-Identifier: Apache-2.0
// One visit of one person: a browser context with its own storage, a page, hands and somebody who watches.
import { join } from "node:path";
import { devices } from "./devices.mjs";
import { failureFolder, pictureFolder } from "./folders.mjs";
import { handsOn } from "./hands.mjs";
import { StudioPage } from "./studio-page.mjs";
import { Watch } from "./watch.mjs";

export const fileNameOf = (title) =>
  title
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "_")
    .replace(/^_|_$/g, "");

/** Runs in each page: without a window there is no dialog to choose a file in, so files come and go as in browsers that have none. */
function withoutFileDialogs() {
  delete globalThis.showSaveFilePicker;
  delete globalThis.showOpenFilePicker;
}

/**
 * @param {object} options device; expects: faults that the test provokes; context: more for the browser's context
 */
export async function visit(
  browser,
  origin,
  title,
  { device = "wide", expects, context: more } = {},
) {
  const context = await browser.newContext({ locale: "en-GB", ...devices[device], ...more });
  await context.tracing.start({ snapshots: true, screenshots: false });
  const watch = new Watch(origin, expects);
  await watch.attach(context);
  await context.addInitScript(withoutFileDialogs);
  const page = await context.newPage();
  const name = fileNameOf(title);
  return {
    browser,
    context,
    page,
    origin,
    watch,
    studio: new StudioPage(page, origin),
    ...(await handsOn(page)),
    /** A picture to be looked at; each test leaves one at its end anyway. */
    picture: (what) => page.screenshot({ path: join(pictureFolder, `${name}-${what}.png`) }),
    end: async (hasFailed) => {
      const [open] = context.pages();
      const folder = hasFailed ? failureFolder : pictureFolder;
      await open
        ?.screenshot({ path: join(folder, `${name}.png`), timeout: 20000 })
        .catch(() => null);
      const trace = hasFailed ? { path: join(failureFolder, `${name}.zip`) } : {};
      await context.tracing.stop(trace).catch(() => null);
      await context.close();
    },
  };
}
