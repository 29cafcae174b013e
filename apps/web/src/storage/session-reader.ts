// SPDX-License-Identifier: Apache-2.0
import type { SessionRow } from "../protocol/messages";
import type { Connection } from "./connection";
import { answerOf, answerOrNull, type TableName } from "./database";
import {
  readDescription,
  readLine,
  readSessionRecord,
  type Description,
  type FoundLine,
  type SessionRecord,
} from "./records";

type Tables = (name: TableName) => IDBObjectStore;

/** Everything of a session: arrays come after all numbers in the order of keys. */
export function linesOf(session: string, from = 0, before?: number): IDBKeyRange {
  return IDBKeyRange.bound([session, from], [session, before ?? []], false, true);
}

async function readAtOnce(tables: Tables, range: IDBKeyRange): Promise<(FoundLine | null)[]> {
  const [keys, values] = await Promise.all([
    answerOf(tables("lines").getAllKeys(range)),
    answerOf<unknown[]>(tables("lines").getAll(range)),
  ]);
  return keys.map((key, at) => readLine(key, values[at]));
}

/** Where the bytes of one value are gone, a browser refuses to give any of them at once. */
async function readSingly(tables: Tables, range: IDBKeyRange): Promise<(FoundLine | null)[]> {
  const keys = await answerOf(tables("lines").getAllKeys(range));
  const values = keys.map((key) => answerOrNull<unknown>(tables("lines").get(key)));
  return (await Promise.all(values)).map((value, at) => readLine(keys[at], value));
}

export interface FoundSession {
  readonly lines: readonly FoundLine[];
  readonly record: SessionRecord | null;
  readonly description: Description;
}

export async function readSession(connection: Connection, id: string): Promise<FoundSession> {
  const range = linesOf(id);
  const found = await connection
    .read((tables) => readAtOnce(tables, range))
    .catch(() => connection.read((tables) => readSingly(tables, range)));
  const [record, description] = await Promise.all(
    (["sessions", "descriptions"] as const).map((name) =>
      connection.read((tables) => answerOrNull<unknown>(tables(name).get(id))).catch(() => null),
    ),
  );
  return {
    lines: found.filter((line) => line !== null),
    record: readSessionRecord(record),
    description: readDescription(description),
  };
}

/** Each session that has lines, found by jumping from the first line of one to the first of the next. */
function sessionIds(tables: Tables): Promise<string[]> {
  return new Promise((resolve, reject) => {
    const ids: string[] = [];
    const request = tables("lines").openKeyCursor(IDBKeyRange.lowerBound([""]));
    request.onerror = () => {
      reject(request.error ?? new Error("the cursor failed"));
    };
    request.onsuccess = () => {
      const cursor = request.result;
      if (cursor === null || !Array.isArray(cursor.key)) {
        resolve(ids);
        return;
      }
      const id: unknown = cursor.key[0];
      if (typeof id !== "string") {
        resolve(ids);
        return;
      }
      ids.push(id);
      cursor.continue([id, []]);
    };
  });
}

async function readRow(tables: Tables, id: string): Promise<SessionRow> {
  const [record, description] = await Promise.all([
    answerOrNull<unknown>(tables("sessions").get(id)),
    answerOrNull<unknown>(tables("descriptions").get(id)),
  ]);
  const { name, picture } = readDescription(description);
  return { id, name, picture, changedMs: readSessionRecord(record)?.changed ?? 0 };
}

/** Every session that has lines, last changed first. */
export async function readRows(connection: Connection): Promise<SessionRow[]> {
  const rows = await connection.read(async (tables) => {
    const ids = await sessionIds(tables);
    return Promise.all(ids.map((id) => readRow(tables, id)));
  });
  return rows.sort((a, b) => b.changedMs - a.changedMs);
}
