// SPDX-License-Identifier: Apache-2.0
// node see_glb.mjs FILE.glb... [--pictures FOLDER]: three.js in headless Chromium loads each file and looks at it from the front.
// Prints one JSON line for each: counts, and the mean colour of what is seen in the upper and the lower half of the model.
import { createReadStream, existsSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { basename, dirname, extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const here = dirname(fileURLToPath(import.meta.url));
const types = { ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript" };
const browserPath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const browserFlags = [
  "--no-sandbox",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

const words = process.argv.slice(2);
const option = words.indexOf("--pictures");
const pictures = option >= 0 ? words.splice(option, 2)[1] : null;

/** Serves the page, three.js and the models; nothing else. */
function serve(models) {
  const server = createServer((request, response) => {
    const path = new URL(request.url, "http://localhost").pathname;
    const model = /^\/model\/(\d+)$/.exec(path);
    const isOurs = path === "/see_glb.html" || path.startsWith("/node_modules/three/");
    const file = model ? models[Number(model[1])] : isOurs && !path.includes("..") ? join(here, path) : null;
    if (!file || !existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" });
    return createReadStream(file).pipe(response);
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

const server = await serve(words);
const browser = await chromium.launch({ executablePath: browserPath, args: browserFlags });
let isAllSeen = words.length > 0;
try {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/see_glb.html`);
  await page.waitForFunction(() => globalThis.see !== undefined, null, { timeout: 20_000 });
  for (const [i, path] of words.entries()) {
    const seen = await page.evaluate((address) => globalThis.see(address), `/model/${i}`);
    if (pictures && seen.picture) {
      writeFileSync(join(pictures, `${basename(path, ".glb")}.png`), Buffer.from(seen.picture.split(",")[1], "base64"));
    }
    delete seen.picture;
    isAllSeen &&= seen.loaded;
    console.log(JSON.stringify({ file: path, ...seen }));
  }
} finally {
  await browser.close();
  server.close();
}
process.exit(isAllSeen ? 0 : 1);
