// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { answerOf } from "./database";
import { bytesOf, FakeBrowser, numbersFrom, textOf, untilTold, type Tab } from "./store-in-test";

/** Laws that hold whatever happens in whatever order. */

const seeds = Array.from({ length: 12 }, (_, at) => at + 1);

/** From now on nothing that the tab writes arrives; at once, or after so many more writes. */
function die(tab: Tab, writesLeft: number): void {
  const write = tab.connection.write.bind(tab.connection);
  let left = writesLeft;
  tab.connection.write = (work) => (left-- > 0 ? write(work) : new Promise(() => undefined));
}

describe("a tab that dies at any moment", () => {
  it.each(seeds)("loses nothing that was said to be saved (seed %i)", async (seed) => {
    const below = numbersFrom(seed);
    const browser = new FakeBrowser();
    let id: string | null = null;
    let whole = "";
    for (let visit = 0; visit < 4; ++visit) {
      const tab = await browser.tab();
      const opened = await tab.store.open(id);
      if (id !== null) whole = textOf(opened.generations[0]?.bytes) ?? "";
      ({ id } = opened);
      let saved = whole;
      tab.store.onState = (state) => {
        tab.states.push(state);
        if (state.kind === "saved") saved = whole;
      };
      const lastWrites = below(4);
      for (let step = below(9); step >= 0; --step) {
        if (step === 0) die(tab, lastWrites);
        const line = `${visit}.${step} `;
        if (below(6) === 0) tab.store.startNew(bytesOf((whole = `new ${line}`)));
        else tab.store.append(bytesOf(((whole += line), line)));
        if (below(2) === 0 && step > 0) await untilTold(tab);
      }
      await new Promise((resolve) => setTimeout(resolve, 2));
      tab.close();
      const after = await browser.tab();
      const { generations } = await after.store.open(id);
      after.close();
      const texts = generations.map(({ bytes }) => textOf(bytes) ?? "");
      const isKept = saved === "" || texts.some((text) => text.startsWith(saved));
      expect(isKept, `saved "${saved}", found ${JSON.stringify(texts)}`).toBe(true);
      expect(generations.every(({ isTorn }) => !isTorn)).toBe(true);
      if (generations.length > 0) continue;
      id = null;
      whole = "";
    }
  });
});

type Damage = (below: (n: number) => number) => unknown;
const damages: Damage[] = [
  () => null,
  () => undefined,
  () => "text",
  (below) => below(1000),
  () => ({}),
  (below) => ({ bytes: Uint8Array.of(below(256)), sum: below(1 << 30) }),
  () => ({ bytes: "text", sum: 0 }),
  () => ({ bytes: [1, 2, 3], sum: {} }),
  () => ({ created: -1, changed: NaN, newest: "a", lines: null, holder: 5 }),
  () => new Map([[1, 2]]),
];

async function damageOne(tab: Tab, below: (n: number) => number): Promise<void> {
  await tab.connection.write(async (tables) => {
    const name = (["sessions", "descriptions", "lines", "lines", "lines"] as const)[below(5)];
    const table = tables(name ?? "lines");
    const keys = await answerOf(table.getAllKeys());
    const key = keys[below(keys.length)];
    if (key === undefined) return;
    if (below(4) === 0) await answerOf(table.delete(key));
    else await answerOf(table.put(damages[below(damages.length)]?.(below), key));
    if (below(8) === 0) await answerOf(table.put("odd", below(2) === 0 ? 7 : [0, ["x"], "y"]));
  });
}

describe("a store with damaged records", () => {
  it.each(seeds)("opens, lists, gives a beginning, and goes on (seed %i)", async (seed) => {
    const below = numbersFrom(1000 + seed);
    const browser = new FakeBrowser();
    const ids: string[] = [];
    for (let count = 0; count < 3; ++count) {
      const tab = await browser.tab();
      ids.push((await tab.store.open(null)).id);
      for (const line of ["start ", "one ", "two ", "three "]) {
        tab.store.append(bytesOf(line));
        await untilTold(tab);
      }
      tab.store.describe("Cat", null);
      tab.close();
    }
    const tab = await browser.tab();
    for (let count = 1 + below(3); count > 0; --count) await damageOne(tab, below);

    const rows = await tab.store.list();
    expect(rows.every(({ id }) => ids.includes(id))).toBe(true);
    for (const id of ids) {
      const { generations } = await tab.store.open(id);
      const text = textOf(generations[0]?.bytes) ?? "";
      expect("start one two three ".startsWith(text)).toBe(true);
      tab.store.append(bytesOf("more "));
      expect((await untilTold(tab)).kind).toBe("saved");
      const opened = await tab.store.open(id);
      expect(textOf(opened.generations[0]?.bytes) ?? "more ").toMatch(/more $/);
    }
  });
});
