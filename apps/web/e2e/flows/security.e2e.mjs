// SPDX-License-Identifier: Apache-2.0
// Whatever a file or a name holds, it is text. That nothing is fetched and no policy breached, the harness checks in every test.
import assert from "node:assert/strict";
import { drawPart, characterOn } from "../harness/drawn.mjs";
import { assertInertSvg } from "../harness/judges.mjs";
import { test } from "../harness/tests.mjs";

const markup = `"><img src=x onerror="globalThis.__xss='name'"><script>globalThis.__xss='script'</script>`;

const circle = `<circle cx="300" cy="300" r="120" fill="none" stroke="#000"/>`;
const svg = (inside, attributes = "") =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="600" height="600" ${attributes}>${inside}${circle}</svg>`;

const hostile = {
  "a script": svg(
    `<script>globalThis.__xss=1</script><script href="http://elsewhere.invalid/a.js"/>`,
  ),
  "a handler": svg(
    `<rect width="9" height="9" onclick="__xss=1" onload="__xss=1"/>`,
    `onload="__xss=1"`,
  ),
  "a foreign object": svg(
    `<foreignObject width="600" height="600"><body xmlns="http://www.w3.org/1999/xhtml"><img src="x" onerror="__xss=1"/><iframe src="javascript:parent.__xss=1"/></body></foreignObject>`,
  ),
  "a link that runs": svg(`<a xlink:href="javascript:globalThis.__xss=1"><text>press</text></a>`),
  "pictures from elsewhere": svg(
    `<image href="http://elsewhere.invalid/a.png" width="9" height="9"/><use xlink:href="http://elsewhere.invalid/a.svg#a"/>`,
  ),
  "style from elsewhere": svg(
    `<style>@import url("http://elsewhere.invalid/a.css"); path{background:url(http://elsewhere.invalid/b)}</style>`,
  ),
  "an animated handler": svg(
    `<set attributeName="onmouseover" to="__xss=1"/><animate onbegin="__xss=1"/>`,
  ),
  "an entity": `<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd"><!ENTITY y "<script>__xss=1</script>">]>${svg("<text>&x;&y;</text>")}`,
  "markup in names": svg(
    `<g id="${markup.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;")}"></g>`,
  ),
};

const scriptThatRan = (page) => page.evaluate(() => globalThis.__xss);

for (const [what, text] of Object.entries(hostile)) {
  test(`an SVG with ${what} is a drawing and nothing else`, {}, async ({ studio, page }) => {
    await studio.open();
    await studio.openFile(`${markup}.svg`, text);
    await page.waitForTimeout(400);
    assert.equal(await scriptThatRan(page), undefined);
    assertInertSvg(String(await studio.written("svg")));
  });
}

test("a part may be named like a script; it is shown as it was typed", {}, async (world) => {
  const { studio, page, mouse } = world;
  await studio.open();
  const { body } = await characterOn(studio);
  await drawPart(world, mouse, body, 1);
  await studio.act("select_all");
  await studio.act("rename_part", markup);
  await studio.until("the name", (state) => state.layers[0].name === markup);
  await page.waitForTimeout(300);
  assert.equal(await scriptThatRan(page), undefined);
  assert.equal(await page.locator("img[src=x]").count(), 0);
  assertInertSvg(String(await studio.written("svg")));

  const file = await studio.written("inkflate");
  await studio.saved();
  await page.reload();
  await studio.until("ready again", (state) => state.layers[0]?.name === markup);
  await studio.act("new");
  await studio.openFile(`${markup}.inkflate`, file);
  await studio.until("opened", (state) => state.layers[0]?.name === markup);
  assert.equal(await scriptThatRan(page), undefined);
});

test("the page cannot make code of text", {}, async ({ studio, page, watch }) => {
  await studio.open();
  await page.evaluate(() => {
    const script = document.createElement("script");
    try {
      script.text = "globalThis.__xss = 1";
      document.body.append(script);
    } catch {
      // Trusted Types say no even before the policy does.
    }
    try {
      document.body.insertAdjacentHTML("beforeend", "<img src=x onerror='__xss=1'>");
    } catch {
      // So they do here.
    }
  });
  assert.ok((await watch.until("policy breach")).length > 0, "there is no policy");
  assert.equal(await scriptThatRan(page), undefined);
  await watch.forget();
});
