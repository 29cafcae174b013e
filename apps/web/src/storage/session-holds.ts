// SPDX-License-Identifier: Apache-2.0

/** Who has which session: two tabs must never write the same one. */
export interface SessionHolds {
  /** Whether it is ours now. Waits so long for a tab that is just going (our own before it was loaded again). */
  take(session: string, patienceMs: number): Promise<boolean>;
  release(session: string): void;
  /** Sessions that are held, ours among them. */
  held(): Promise<ReadonlySet<string>>;
}

const prefix = "inkflate.session.";

/** By locks that the browser takes from a tab when it ends, however it ends. */
export class LockedHolds implements SessionHolds {
  private readonly releases = new Map<string, () => void>();

  constructor(private readonly locks: LockManager) {}

  take(session: string, patienceMs: number): Promise<boolean> {
    if (this.releases.has(session)) return Promise.resolve(true);
    const options: LockOptions =
      patienceMs > 0 ? { signal: AbortSignal.timeout(patienceMs) } : { ifAvailable: true };
    return new Promise((resolve) => {
      const hold = (lock: Lock | null): Promise<void> | undefined => {
        resolve(lock !== null);
        if (lock === null) return undefined;
        return new Promise((release) => {
          this.releases.set(session, release);
        });
      };
      this.locks.request(prefix + session, options, hold).catch(() => {
        resolve(false);
      });
    });
  }

  release(session: string): void {
    this.releases.get(session)?.();
    this.releases.delete(session);
  }

  async held(): Promise<ReadonlySet<string>> {
    const { held = [] } = await this.locks.query();
    const names = held.map((lock) => lock.name ?? "").filter((name) => name.startsWith(prefix));
    return new Set(names.map((name) => name.slice(prefix.length)));
  }
}

/** How long the other tabs have for an answer. */
const answerMs = 200;

type Call =
  | { readonly kind: "who"; readonly asker: string }
  | { readonly kind: "mine"; readonly asker: string; readonly session: string };

/**
 * By asking around, where there are no locks: a page that comes over plain http from another machine has none. Two tabs may
 * still take the same session in the same moment, or one may be asleep; then the holder in the session's record tells them apart
 * at the next write, and the one that was late goes on as a session of its own.
 */
export class AskedHolds implements SessionHolds {
  private readonly mine = new Set<string>();
  private readonly heard = new Map<string, Set<string>>();

  constructor(
    private readonly channel: BroadcastChannel,
    private readonly newId: () => string,
  ) {
    channel.onmessage = ({ data }: MessageEvent<Call>) => {
      if (data.kind === "mine") this.heard.get(data.asker)?.add(data.session);
      else for (const session of this.mine) this.say({ kind: "mine", asker: data.asker, session });
    };
  }

  async take(session: string): Promise<boolean> {
    if (this.mine.has(session)) return true;
    if ((await this.held()).has(session)) return false;
    this.mine.add(session);
    return true;
  }

  release(session: string): void {
    this.mine.delete(session);
  }

  async held(): Promise<ReadonlySet<string>> {
    const asker = this.newId();
    const answers = new Set(this.mine);
    this.heard.set(asker, answers);
    this.say({ kind: "who", asker });
    await new Promise((resolve) => setTimeout(resolve, answerMs));
    this.heard.delete(asker);
    return answers;
  }

  private say(call: Call): void {
    this.channel.postMessage(call);
  }
}
