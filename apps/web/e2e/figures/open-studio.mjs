// SPDX-License-Identifier: Apache-2.0
import { devices } from "../harness/devices.mjs";
import { handsOn } from "../harness/hands.mjs";
import { StudioPage } from "../harness/studio-page.mjs";

/** A studio in a context of its own, with hands; nothing else watches, so that nothing else costs time. */
export async function openStudio(browser, origin) {
  const context = await browser.newContext(devices.wide);
  const page = await context.newPage();
  const studio = new StudioPage(page, origin);
  await studio.open();
  await studio.act("zoom_actual");
  return { browser, context, page, studio, ...(await handsOn(page)) };
}

export const ms = (value) => `${value.toFixed(1)} ms`;
export const kB = (bytes) => `${(bytes / 1024).toFixed(0)} kB`;
export const MB = (value) => `${value.toFixed(1)} MB`;

/** The value below which this share of them lies. */
export function percentile(values, share) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
