// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { bytesOf, FakeBrowser, textOf, untilTold, type Tab } from "./store-in-test";

async function reopened(browser: FakeBrowser, id: string): Promise<(string | null)[]> {
  const tab = await browser.tab();
  const { generations } = await tab.store.open(id);
  tab.close();
  return generations.map(({ bytes }) => textOf(bytes));
}

async function drawn(browser: FakeBrowser, ...lines: string[]): Promise<[Tab, string]> {
  const tab = await browser.tab();
  const { id } = await tab.store.open(null);
  for (const line of lines) tab.store.append(bytesOf(line));
  await untilTold(tab);
  return [tab, id];
}

describe("the journal store", () => {
  it("gives back what was appended, in order", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawn(browser, "start ", "one ", "two ");
    tab.store.append(bytesOf("three"));
    await untilTold(tab);
    tab.close();
    expect(await reopened(browser, id)).toEqual(["start one two three"]);
  });

  it("says saving at once, and saved only when it is in the database", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawn(browser, "start ");
    tab.states.length = 0;
    tab.store.append(bytesOf("one"));
    expect(tab.states).toEqual([{ kind: "saving" }]);
    expect((await untilTold(tab)).kind).toBe("saved");
    tab.close();
    expect(await reopened(browser, id)).toEqual(["start one"]);
  });

  it("gives the name back that the drawing had when it was saved last", async () => {
    const browser = new FakeBrowser();
    const tab = await browser.tab();
    const { id, name } = await tab.store.open(null);
    expect(name).toBe("");
    tab.store.append(bytesOf("start "));
    tab.store.rename("drawing");
    await untilTold(tab);
    tab.store.append(bytesOf("open "));
    tab.store.rename("cat");
    await untilTold(tab);
    tab.close();
    const again = await browser.tab();
    expect((await again.store.open(id)).name).toBe("cat");
  });

  it("keeps the picture when the drawing goes on under its name or another", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawn(browser, "start ");
    const picture = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
    tab.store.describe("cat", picture);
    await tab.store.open(null);
    for (const name of ["cat", "dog"]) {
      await tab.store.open(id);
      tab.store.rename(name);
      await tab.store.open(null);
      expect(await tab.store.list()).toMatchObject([{ id, name, picture }]);
    }
  });

  it("leaves nothing behind of a session in which nothing was drawn", async () => {
    const browser = new FakeBrowser();
    const tab = await browser.tab();
    const { id } = await tab.store.open(null);
    tab.store.describe("nothing", null);
    tab.close();
    const other = await browser.tab();
    expect(await other.store.list()).toEqual([]);
    expect((await other.store.open(id)).id).not.toBe(id);
  });

  it("keeps three generations, newest first", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawn(browser, "a");
    for (const text of ["b", "c", "d", "e"]) {
      tab.store.startNew(bytesOf(text));
      tab.store.append(bytesOf("+"));
      await untilTold(tab);
    }
    tab.close();
    expect(await reopened(browser, id)).toEqual(["e+", "d+", "c+"]);
  });

  it("makes no generation of what the newest already is", async () => {
    const browser = new FakeBrowser();
    const [first, id] = await drawn(browser, "all of it");
    first.close();
    for (let visit = 0; visit < 5; ++visit) {
      const tab = await browser.tab();
      const { generations } = await tab.store.open(id);
      tab.store.startNew(generations[0]?.bytes ?? bytesOf(""));
      expect((await untilTold(tab)).kind).toBe("saved");
      tab.close();
    }
    expect(await reopened(browser, id)).toEqual(["all of it"]);
  });

  it("goes on after a visit with a copy, so that one damaged place is not the end", async () => {
    const browser = new FakeBrowser();
    const [first, id] = await drawn(browser, "start ", "one ");
    first.close();
    const second = await browser.tab();
    await second.store.open(id);
    second.store.append(bytesOf("two"));
    await untilTold(second);
    second.close();
    expect(await reopened(browser, id)).toEqual(["start one two", "start one "]);
  });

  it("opens a new session where the wanted one is held by another tab", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawn(browser, "mine");
    const other = await browser.tab();
    const opened = await other.store.open(id);
    expect(opened.id).not.toBe(id);
    expect(opened.generations).toEqual([]);
    other.store.append(bytesOf("other"));
    await untilTold(other);
    tab.close();
    other.close();
    expect(await reopened(browser, id)).toEqual(["mine"]);
    expect(await reopened(browser, opened.id)).toEqual(["other"]);
  });

  it("lists what no tab holds, last changed first, with name and picture", async () => {
    const browser = new FakeBrowser();
    const picture = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 1, 2, 3);
    const [first, firstId] = await drawn(browser, "first");
    first.store.describe("Cat", picture);
    await first.store.open(null);
    const [second, secondId] = await drawn(browser, "second");
    second.close();
    const [, heldId] = await drawn(browser, "held");
    const rows = await first.store.list();
    expect(rows.map(({ id, name }) => [id, name])).toEqual([
      [secondId, ""],
      [firstId, "Cat"],
    ]);
    expect(rows[1]?.picture).toEqual(picture);
    expect(rows.map(({ id }) => id)).not.toContain(heldId);
  });

  it("forgets a session, but never one that is held", async () => {
    const browser = new FakeBrowser();
    const [first, firstId] = await drawn(browser, "first");
    const [second, secondId] = await drawn(browser, "second");
    await second.store.forget(firstId);
    await second.store.forget(secondId);
    first.close();
    await second.store.forget(firstId);
    second.close();
    const other = await browser.tab();
    expect((await other.store.list()).map(({ id }) => id)).toEqual([secondId]);
  });

  it("gives all bytes of a session as they are", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawn(browser, "old ", "older ");
    tab.store.startNew(bytesOf("new"));
    expect(textOf(await tab.store.raw(id))).toBe("newold older ");
    expect(textOf(await tab.store.raw("nobody"))).toBe("");
  });

  it("keeps at most twenty sessions", async () => {
    const browser = new FakeBrowser();
    for (let count = 0; count < 23; ++count) {
      const [tab] = await drawn(browser, `drawing ${count}`);
      tab.close();
    }
    const tab = await browser.tab();
    await tab.store.open(null);
    await expect.poll(async () => (await tab.store.list()).length).toBe(20);
    const ids = (await tab.store.list()).map(({ id }) => id);
    expect(textOf(await tab.store.raw(ids[0] ?? ""))).toBe("drawing 22");
  });
});
