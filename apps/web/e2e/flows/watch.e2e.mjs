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
  for (const kind of ["policy breach", "console error", "page error"]) {
    assert.ok((await watch.until(kind)).length > 0, kind);
  }
  await watch.forget();
});

const withoutPolicy = { context: { bypassCSP: true } };
test("a request to elsewhere is noticed", withoutPolicy, async ({ studio, page, watch }) => {
  await studio.open();
  await page.evaluate(() => void fetch("https://elsewhere.invalid/").catch(() => null));
  const requests = await watch.until("foreign request");
  // The browser says itself that it has failed.
  await watch.until("console error");
  await watch.forget();
  assert.equal(requests.length, 1);
});
