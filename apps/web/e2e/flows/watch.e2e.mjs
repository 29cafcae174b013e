// SPDX-License-Identifier: Apache-2.0
// The tests would be worth little if they did not notice.
import assert from "node:assert/strict";
import { test } from "../harness/tests.mjs";

test("what must never happen is noticed when it does", {}, async ({ studio, page, watch }) => {
  await studio.open();
  await page.evaluate(() => {
    void fetch("https://elsewhere.invalid/").catch(() => null);
    const picture = document.createElement("img");
    picture.src = "http://elsewhere.invalid/picture.png";
    document.body.append(picture);
    console.error("planted");
    setTimeout(() => {
      throw new Error("planted");
    });
  });
  await page.waitForTimeout(500);
  const kinds = new Set(watch.faults.map(({ kind }) => kind));
  watch.faults.length = 0;
  assert.ok(kinds.has("policy breach"));
  assert.ok(kinds.has("console error"));
  assert.ok(kinds.has("page error"));
});

const withoutPolicy = { context: { bypassCSP: true } };
test("a request to elsewhere is noticed", withoutPolicy, async ({ studio, page, watch }) => {
  await studio.open();
  await page.evaluate(() => void fetch("https://elsewhere.invalid/").catch(() => null));
  await page.waitForTimeout(500);
  const requests = watch.faults.filter(({ kind }) => kind === "foreign request");
  watch.faults.length = 0;
  assert.equal(requests.length, 1);
});
