// SPDX-License-Identifier: Apache-2.0
import "fake-indexeddb/auto";
import { IDBFactory } from "fake-indexeddb";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { SaveState } from "../protocol/messages";
import { openJournalStore } from "./open-journal-store";
import { bytesOf, textOf } from "./store-in-test";

beforeEach(() => {
  vi.stubGlobal("navigator", {});
});
afterEach(() => {
  vi.unstubAllGlobals();
});

async function statesOfOneLine(): Promise<SaveState["kind"][]> {
  const store = await openJournalStore();
  const states: SaveState["kind"][] = [];
  store.onState = ({ kind }) => states.push(kind);
  const { id } = await store.open(null);
  store.append(bytesOf("line"));
  expect(textOf(await store.raw(id))).toBe("line");
  return states;
}

function openOther(factory: IDBFactory, version: number, table: string): Promise<IDBDatabase> {
  return new Promise((resolve) => {
    const request = factory.open("inkflate", version);
    request.onupgradeneeded = () => request.result.createObjectStore(table);
    request.onsuccess = () => {
      resolve(request.result);
    };
  });
}

describe("the store of a browser", () => {
  it("keeps what is drawn", async () => {
    vi.stubGlobal("indexedDB", new IDBFactory());
    expect((await statesOfOneLine()).at(-1)).toBe("saved");
  });

  it("has another place where a newer version has been at the first", async () => {
    const factory = new IDBFactory();
    (await openOther(factory, 99, "sessions")).close();
    vi.stubGlobal("indexedDB", factory);
    expect((await statesOfOneLine()).at(-1)).toBe("saved");
  });

  it("has another place where tables are missing at the first", async () => {
    const factory = new IDBFactory();
    (await openOther(factory, 1, "odd")).close();
    vi.stubGlobal("indexedDB", factory);
    expect((await statesOfOneLine()).at(-1)).toBe("saved");
  });

  it.each([
    ["is not there", undefined],
    [
      "throws",
      {
        open: () => {
          throw new DOMException("", "SecurityError");
        },
      },
    ],
  ])("goes on in memory and says so where storage %s", async (_, factory) => {
    vi.stubGlobal("indexedDB", factory);
    expect(new Set(await statesOfOneLine())).toEqual(new Set(["refused"]));
  });

  it("goes on in memory where storage never answers", async () => {
    vi.useFakeTimers();
    vi.stubGlobal("indexedDB", { open: () => ({}) });
    const opening = openJournalStore();
    await vi.runAllTimersAsync();
    const store = await opening;
    vi.useRealTimers();
    expect(await store.list()).toEqual([]);
  });
});
