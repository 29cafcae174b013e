// SPDX-License-Identifier: Apache-2.0
import { areSameBytes, joinBytes } from "./bytes";
import { checkSum } from "./check-sum";
import type { Generation } from "./journal-store";

/**
 * What lies in the database. Whatever is read may have been damaged, or written by another version or another hand: these
 * functions take anything and give what can be believed.
 */

export interface SessionRecord {
  readonly created: number;
  readonly changed: number;
  /** The newest generation, and how many lines it has. */
  readonly newest: number;
  readonly lines: number;
  /** Who has written last: another writer sees that the session is no longer its own. */
  readonly holder: string;
}

export interface Description {
  readonly name: string;
  /** PNG */
  readonly picture: Uint8Array | null;
}

export interface LineRecord {
  readonly bytes: Uint8Array;
  readonly sum: number;
}

export type LineKey = [session: string, generation: number, sequence: number];

/** A line as it was found; bytes null: nothing to be read there. */
export interface FoundLine {
  readonly key: LineKey;
  readonly bytes: Uint8Array | null;
  readonly isWhole: boolean;
}

const pngStart = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
const longestName = 1000;
const largestPicture = 1 << 20;

function member(value: unknown, name: string): unknown {
  return typeof value === "object" && value !== null
    ? (value as Readonly<Record<string, unknown>>)[name]
    : undefined;
}

function isCount(value: unknown): value is number {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}

export function readSessionRecord(value: unknown): SessionRecord | null {
  const created = member(value, "created");
  const changed = member(value, "changed");
  const newest = member(value, "newest");
  const lines = member(value, "lines");
  const holder = member(value, "holder");
  if (!isCount(created) || !isCount(changed) || !isCount(newest) || !isCount(lines)) return null;
  return typeof holder === "string" ? { created, changed, newest, lines, holder } : null;
}

export function readDescription(value: unknown): Description {
  const name = member(value, "name");
  const picture = member(value, "picture");
  const isPicture =
    picture instanceof Uint8Array &&
    picture.byteLength <= largestPicture &&
    areSameBytes(picture.subarray(0, pngStart.length), pngStart);
  return {
    name: typeof name === "string" ? name.slice(0, longestName) : "",
    picture: isPicture ? picture : null,
  };
}

/** The sum is of the place too: a line elsewhere is as wrong as a damaged one. */
export function makeLine(key: LineKey, bytes: Uint8Array): LineRecord {
  return { bytes: joinBytes([bytes]), sum: checkSum(key.join(" "), bytes) };
}

/** null: the key is not that of a line of a session. */
export function readLine(key: unknown, value: unknown): FoundLine | null {
  if (!Array.isArray(key) || key.length !== 3) return null;
  const [session, generation, sequence] = key as unknown[];
  if (typeof session !== "string" || !isCount(generation) || !isCount(sequence)) return null;
  const place: LineKey = [session, generation, sequence];
  const bytes = member(value, "bytes");
  if (!(bytes instanceof Uint8Array)) return { key: place, bytes: null, isWhole: false };
  const isWhole = member(value, "sum") === checkSum(place.join(" "), bytes);
  return { key: place, bytes, isWhole };
}

function assembleOne(number: number, lines: readonly FoundLine[], wanted: number): Generation {
  const whole: Uint8Array[] = [];
  for (const line of lines) {
    if (line.bytes === null || !line.isWhole || line.key[2] !== whole.length) break;
    whole.push(line.bytes);
  }
  const isTorn = whole.length < Math.max(lines.length, wanted);
  return { number, bytes: joinBytes(whole), isTorn };
}

/** Whether an older journal holds all that can be read of a torn one, and more: the torn one began as a copy of it. */
function knowsMore(older: Generation, torn: Generation): boolean {
  const start = older.bytes.subarray(0, torn.bytes.byteLength);
  return older.bytes.byteLength > torn.bytes.byteLength && areSameBytes(start, torn.bytes);
}

/** The best first: a torn one stands behind one that knows more. */
function ordered(newestFirst: readonly Generation[]): Generation[] {
  const [newest, ...others] = newestFirst;
  if (!newest) return [];
  const better = newest.isTorn ? others.find((each) => knowsMore(each, newest)) : undefined;
  if (!better) return [...newestFirst];
  return [better, ...newestFirst.filter((each) => each !== better)];
}

/** lines: of one session, in the order of their keys. record: null: lost. The one to go on with first. */
export function assembleGenerations(
  lines: readonly FoundLine[],
  record: SessionRecord | null,
): Generation[] {
  const byNumber = new Map<number, FoundLine[]>();
  if (record !== null && record.lines > 0 && lines.length > 0) byNumber.set(record.newest, []);
  for (const line of lines) {
    const others = byNumber.get(line.key[1]);
    if (others) others.push(line);
    else byNumber.set(line.key[1], [line]);
  }
  const newestFirst = [...byNumber]
    .sort(([a], [b]) => b - a)
    .map(([number, own]) => assembleOne(number, own, number === record?.newest ? record.lines : 0));
  return ordered(newestFirst);
}

/** Everything of a session, damaged or not, newest generation first, so that a reader of journals begins with it. */
export function rawBytes(lines: readonly FoundLine[]): Uint8Array<ArrayBuffer> {
  const inOrder = [...lines].sort((a, b) => b.key[1] - a.key[1] || a.key[2] - b.key[2]);
  return joinBytes(inOrder.map((line) => line.bytes ?? new Uint8Array(0)));
}
