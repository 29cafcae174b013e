// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { SessionGone } from "./session-table";
import { bytesOf, FakeBrowser, FakeHolds, textOf, untilTold, type Tab } from "./store-in-test";

const full = () => new DOMException("", "QuotaExceededError");

/** From now on writes fail as often as this says; how often they have been tried. */
function failWrites(tab: Tab, fault: () => Error, times = Infinity): () => number {
  const write = tab.connection.write.bind(tab.connection);
  let tried = 0;
  tab.connection.write = (work) => {
    tried += 1;
    return tried <= times ? Promise.reject(fault()) : write(work);
  };
  return () => tried;
}

async function reopened(browser: FakeBrowser, id: string): Promise<(string | null)[]> {
  const tab = await browser.tab();
  const { generations } = await tab.store.open(id);
  tab.close();
  return generations.map(({ bytes }) => textOf(bytes));
}

async function drawing(browser: FakeBrowser): Promise<[Tab, string]> {
  const tab = await browser.tab();
  const { id } = await tab.store.open(null);
  tab.store.append(bytesOf("start "));
  await untilTold(tab);
  return [tab, id];
}

async function append(tab: Tab, text: string): Promise<string> {
  tab.states.length = 0;
  tab.store.append(bytesOf(text));
  const state = await untilTold(tab);
  return state.kind === "refused" ? state.why : state.kind;
}

describe("a device that is full", () => {
  it("is told, and everything is written when there is room again", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawing(browser);
    const write = tab.connection.write.bind(tab.connection);
    failWrites(tab, full);
    expect(await append(tab, "one ")).toBe("full");
    expect(await append(tab, "two ")).toBe("full");
    tab.connection.write = write;
    expect(await append(tab, "three ")).toBe("saved");
    tab.close();
    expect(await reopened(browser, id)).toEqual(["start one two three "]);
  });

  it("is relieved of our own old generations before anybody hears of it", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawing(browser);
    for (const text of ["second ", "third "]) {
      tab.store.startNew(bytesOf(text));
      await untilTold(tab);
    }
    failWrites(tab, full, 1);
    expect(await append(tab, "more ")).toBe("saved");
    tab.close();
    expect(await reopened(browser, id)).toEqual(["third more "]);
  });

  it("does not cost a picture's worth of safety", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawing(browser);
    const tried = failWrites(tab, full, 1);
    tab.store.describe("Cat", null);
    await expect.poll(tried).toBe(1);
    expect(await append(tab, "one ")).toBe("saved");
    tab.close();
    expect(await reopened(browser, id)).toEqual(["start one "]);
  });
});

describe("a browser that refuses", () => {
  it("is told as such", async () => {
    const browser = new FakeBrowser();
    const [tab] = await drawing(browser);
    failWrites(tab, () => new Error("some fault"));
    expect(await append(tab, "one ")).toBe("unavailable");
  });

  it("is not asked for ever", async () => {
    const browser = new FakeBrowser();
    const [tab] = await drawing(browser);
    const tried = failWrites(tab, () => new SessionGone());
    expect(await append(tab, "one ")).toBe("unavailable");
    expect(tried()).toBeLessThan(10);
  });
});

describe("a session whose data were cleared", () => {
  it("is written anew from what the tab knows", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawing(browser);
    await append(tab, "one ");
    await new Promise((resolve) => {
      browser.factory.deleteDatabase("inkflate").onsuccess = resolve;
    });
    expect(await append(tab, "two ")).toBe("saved");
    expect(await append(tab, "three ")).toBe("saved");
    tab.close();
    expect(await reopened(browser, id)).toEqual(["start one two three "]);
  });
});

describe("two tabs that believe to have the same session", () => {
  it("end with two sessions, and both keep all of theirs", async () => {
    const browser = new FakeBrowser();
    const [first, id] = await drawing(browser);
    first.close();
    const [one, other] = [await browser.tab(), await browser.tab(new FakeHolds(new Set()))];
    await one.store.open(id);
    await other.store.open(id);
    await append(one, "one ");
    await append(other, "other ");
    await append(one, "two ");
    await append(other, "more ");
    one.close();
    const rows = await one.store.list();
    const raws = await Promise.all(rows.map((row) => reopened(browser, row.id)));
    const newest = [...raws.map(([text]) => text), (await reopened(browser, id))[0]];
    expect(newest).toContain("start one two ");
    expect(newest).toContain("start other more ");
  });
});

describe("a new generation", () => {
  it("is written again where it cannot be read back, before older ones go", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawing(browser);
    const read = tab.connection.read.bind(tab.connection);
    tab.connection.read = (work) => {
      tab.connection.read = read;
      return Promise.resolve(null)
        .then(() => read(work))
        .then(() => undefined as never);
    };
    tab.store.startNew(bytesOf("again "));
    expect((await untilTold(tab)).kind).toBe("saved");
    expect(await append(tab, "and on ")).toBe("saved");
    tab.close();
    expect(await reopened(browser, id)).toEqual(["again and on ", "again ", "start "]);
  });
});

describe("a long sitting", () => {
  it("leaves copies, so that no damaged line costs more than half of it", async () => {
    const browser = new FakeBrowser();
    const [tab, id] = await drawing(browser);
    for (let count = 0; count < 100; ++count) tab.store.append(bytesOf("line "));
    await untilTold(tab);
    tab.close();
    const found = await reopened(browser, id);
    expect(found[0]).toBe(`start ${"line ".repeat(100)}`);
    expect(found.length).toBeGreaterThan(1);
    expect(found[1]?.length).toBeGreaterThan((found[0]?.length ?? 0) / 4);
  });
});
