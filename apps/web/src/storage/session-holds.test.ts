// SPDX-License-Identifier: Apache-2.0
import { afterEach, describe, expect, it } from "vitest";
import { AskedHolds, LockedHolds, type SessionHolds } from "./session-holds";

const channels: BroadcastChannel[] = [];
let ids = 0;

function askedTab(): SessionHolds {
  const channel = new BroadcastChannel("sessions in a test");
  channels.push(channel);
  return new AskedHolds(channel, () => `asker ${++ids}`);
}

afterEach(() => {
  for (const channel of channels.splice(0)) channel.close();
});

/** As much of the browser's lock manager as the studio asks for. */
class FakeLocks implements LockManager {
  private readonly tails = new Map<string, Promise<unknown>>();

  request<T>(name: string, ...more: unknown[]): Promise<Awaited<T>> {
    const [options, hold] = more as [LockOptions, (lock: Lock | null) => Awaited<T>];
    const before = this.tails.get(name);
    if (before && options.ifAvailable) return Promise.resolve(hold(null));
    const signal = options.signal;
    const run = Promise.resolve(before).then(() => {
      signal?.throwIfAborted();
      return hold({ name, mode: "exclusive" });
    });
    const tail: Promise<unknown> = run
      .catch(() => null)
      .then(() => {
        if (this.tails.get(name) === tail) this.tails.delete(name);
      });
    this.tails.set(name, tail);
    if (!signal) return run;
    const late = new Promise<never>((_, reject) => {
      signal.addEventListener("abort", () => {
        reject(new DOMException("", "AbortError"));
      });
    });
    return Promise.race([run, late]);
  }

  query(): Promise<LockManagerSnapshot> {
    const held = [...this.tails.keys(), "of somebody else"].map((name) => ({ name }));
    return Promise.resolve({ held });
  }
}

const ways: [string, () => () => SessionHolds][] = [
  ["by asking around", () => askedTab],
  [
    "by locks",
    () => {
      const locks = new FakeLocks();
      return () => new LockedHolds(locks);
    },
  ],
];

describe.each(ways)("a session that is held %s", (_, makeBrowser) => {
  it("is held by one tab only, until that lets go", async () => {
    const newTab = makeBrowser();
    const [one, other] = [newTab(), newTab()];
    expect(await one.take("s", 0)).toBe(true);
    expect(await one.take("s", 0)).toBe(true);
    expect(await other.take("s", 0)).toBe(false);
    expect(await other.take("t", 0)).toBe(true);
    one.release("s");
    expect(await other.take("s", 100)).toBe(true);
    expect(await one.take("s", 0)).toBe(false);
  });

  it("is known to all tabs", async () => {
    const newTab = makeBrowser();
    const [one, other] = [newTab(), newTab()];
    await one.take("s", 0);
    await other.take("t", 0);
    expect(await one.held()).toEqual(new Set(["s", "t"]));
    expect(await newTab().held()).toEqual(new Set(["s", "t"]));
  });
});

describe("a lock", () => {
  it("is waited for while the tab before it goes", async () => {
    const locks = new FakeLocks();
    const [before, after] = [new LockedHolds(locks), new LockedHolds(locks)];
    await before.take("s", 0);
    const taking = after.take("s", 5000);
    before.release("s");
    expect(await taking).toBe(true);
  });

  it("is not waited for longer than patience lasts", async () => {
    const locks = new FakeLocks();
    const [before, after] = [new LockedHolds(locks), new LockedHolds(locks)];
    await before.take("s", 0);
    expect(await after.take("s", 20)).toBe(false);
  });
});
