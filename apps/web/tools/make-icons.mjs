// SPDX-License-Identifier: Apache-2.0
// node make-icons.mjs: makes public/icons/*.png of icon.svg, with the browser at /usr/bin/chromium.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const folder = fileURLToPath(new URL("../public/icons/", import.meta.url));
const icon = readFileSync(`${folder}icon.svg`, "utf8");
// Systems cut a maskable icon to their own shape: paper to the edges, and the drop within the inner 80 %.
const maskable = icon
  .replace(' rx="112"', "")
  .replace('<g id="drop">', '<g transform="translate(256 256) scale(0.78) translate(-260 -252)">');

const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
const page = await browser.newPage();
for (const [name, svg, sizePx] of [
  ["icon-192.png", icon, 192],
  ["icon-512.png", icon, 512],
  ["icon-maskable-512.png", maskable, 512],
]) {
  await page.setViewportSize({ width: sizePx, height: sizePx });
  const sized = svg.replace("<svg ", `<svg width="${sizePx}" height="${sizePx}" `);
  await page.setContent(`<style>body { margin: 0 } svg { display: block }</style>${sized}`);
  await page.screenshot({ path: folder + name, omitBackground: true });
}
await browser.close();
