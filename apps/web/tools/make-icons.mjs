// SPDX-License-Identifier: Apache-2.0
// node make-icons.mjs: makes public/icons/*.png and public/favicon.ico of icon.svg, with the browser at /usr/bin/chromium.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const folder = fileURLToPath(new URL("../public/icons/", import.meta.url));
const icon = readFileSync(`${folder}icon.svg`, "utf8");
// Systems cut a maskable icon to their own shape: paper to the edges, and the drop within the inner 80 %.
const maskable = icon
  .replace(' rx="112"', "")
  .replace('<g id="drop">', '<g transform="translate(256 256) scale(0.78) translate(-260 -252)">');

/** One PNG as an .ico file: browsers ask for it wherever a file of ours is opened by itself. */
function icoOf(png, sizePx) {
  const head = Buffer.alloc(22);
  head.writeUInt16LE(1, 2); // an icon
  head.writeUInt16LE(1, 4); // with one picture
  head.writeUInt8(sizePx, 6);
  head.writeUInt8(sizePx, 7);
  head.writeUInt16LE(1, 10);
  head.writeUInt16LE(32, 12);
  head.writeUInt32LE(png.length, 14);
  head.writeUInt32LE(head.length, 18);
  return Buffer.concat([head, png]);
}

const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
const page = await browser.newPage();

async function pictureOf(svg, sizePx) {
  await page.setViewportSize({ width: sizePx, height: sizePx });
  const sized = svg.replace("<svg ", `<svg width="${sizePx}" height="${sizePx}" `);
  await page.setContent(`<style>body { margin: 0 } svg { display: block }</style>${sized}`);
  return page.screenshot({ omitBackground: true });
}

writeFileSync(`${folder}icon-192.png`, await pictureOf(icon, 192));
writeFileSync(`${folder}icon-512.png`, await pictureOf(icon, 512));
writeFileSync(`${folder}icon-maskable-512.png`, await pictureOf(maskable, 512));
writeFileSync(`${folder}../favicon.ico`, icoOf(await pictureOf(icon, 32), 32));
await browser.close();
