// SPDX-License-Identifier: Apache-2.0
import { areSameBytes } from "./bytes";
import type { Connection } from "./connection";
import { answerOf, answerOrNull } from "./database";
import {
  makeLine,
  readLine,
  readSessionRecord,
  type Description,
  type LineKey,
  type SessionRecord,
} from "./records";
import { linesOf } from "./session-reader";

/** How many generations are kept. */
const keptGenerations = 3;

/** The record of the session is not there any more: somebody has cleared the data. */
export class SessionGone extends Error {}
/** Another tab has written to the session. */
export class SessionTaken extends Error {}
/** What was read back is not what was written. */
export class ReadBackDiffers extends Error {}

/** What one write does to the database; each promise settles when that is on the disk or nothing has changed. */
export class SessionTable {
  constructor(private readonly connection: Connection) {}

  /**
   * Adds a line, or begins a generation with it where it is the first.
   *
   * in      holders: who may have written the session before us
   * errors  SessionGone, SessionTaken, and what the browser throws
   */
  async addLine(
    key: LineKey,
    bytes: Uint8Array,
    record: SessionRecord,
    holders: readonly string[],
  ): Promise<void> {
    const [session, generation, sequence] = key;
    await this.connection.write(async (tables) => {
      const before = readSessionRecord(await answerOf<unknown>(tables("sessions").get(session)));
      if (before === null && sequence > 0) throw new SessionGone();
      if (before !== null && !holders.includes(before.holder)) throw new SessionTaken();
      if (sequence === 0) tables("lines").delete(linesOf(session, generation, generation + 1));
      tables("lines").put(makeLine(key, bytes), key);
      tables("sessions").put(record, session);
    });
  }

  /** Older generations go only when the new one has proved to be there. */
  async proveAndDropOld(key: LineKey, bytes: Uint8Array): Promise<void> {
    const value = await this.connection.read((tables) =>
      answerOrNull<unknown>(tables("lines").get(key)),
    );
    const line = readLine(key, value);
    if (!line?.isWhole || line.bytes === null || !areSameBytes(line.bytes, bytes)) {
      throw new ReadBackDiffers();
    }
    await this.dropBefore(key[0], key[1] - keptGenerations + 1);
  }

  async dropBefore(session: string, generation: number): Promise<void> {
    if (generation <= 0) return;
    await this.connection.write((tables) =>
      answerOf(tables("lines").delete(linesOf(session, 0, generation))),
    );
  }

  async describe(session: string, description: Description): Promise<void> {
    await this.connection.write((tables) =>
      answerOf(tables("descriptions").put(description, session)),
    );
  }

  async forget(session: string): Promise<void> {
    await this.connection.write(async (tables) => {
      await Promise.all([
        answerOf(tables("lines").delete(linesOf(session))),
        answerOf(tables("sessions").delete(session)),
        answerOf(tables("descriptions").delete(session)),
      ]);
    });
  }
}
