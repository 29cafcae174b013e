// SPDX-License-Identifier: Apache-2.0

/** The few things that the store wants of IndexedDB, as promises. */

export const tableNames = ["sessions", "descriptions", "lines"] as const;
export type TableName = (typeof tableNames)[number];

const version = 1;

/** A request that never answers (a known fault of some browsers) must not keep the studio from starting. */
const patienceMs = 3000;

export function answerOf<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => {
      resolve(request.result);
    };
    request.onerror = () => {
      reject(request.error ?? new Error("the request failed"));
    };
  });
}

/** As answerOf, but what cannot be read is null, and the transaction goes on. */
export function answerOrNull<T>(request: IDBRequest<T>): Promise<T | null> {
  return new Promise((resolve) => {
    request.onsuccess = () => {
      resolve(request.result);
    };
    request.onerror = (event) => {
      event.preventDefault();
      event.stopPropagation();
      resolve(null);
    };
  });
}

function endOf(transaction: IDBTransaction): Promise<void> {
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => {
      resolve();
    };
    transaction.onabort = () => {
      reject(transaction.error ?? new Error("the transaction was aborted"));
    };
  });
}

function abort(transaction: IDBTransaction): void {
  try {
    transaction.abort();
  } catch {
    // It has ended by itself.
  }
}

/** Does the work in one transaction, and answers when that is on the disk. Work that throws changes nothing. */
export async function transact<T>(
  database: IDBDatabase,
  mode: "readonly" | "readwrite",
  work: (table: (name: TableName) => IDBObjectStore) => Promise<T>,
): Promise<T> {
  const transaction = database.transaction(tableNames, mode, { durability: "strict" });
  const end = endOf(transaction);
  const result = work((name) => transaction.objectStore(name)).catch((error: unknown) => {
    abort(transaction);
    throw error;
  });
  const [value] = await Promise.all([result, end]);
  return value;
}

function makeTables(database: IDBDatabase): void {
  for (const name of tableNames) {
    if (!database.objectStoreNames.contains(name)) database.createObjectStore(name);
  }
}

/** Rejects where the browser refuses, where a newer version has been there, or where tables are missing. */
export function openDatabase(factory: IDBFactory, name: string): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = factory.open(name, version);
    let isGivenUp = false;
    const giveUp = (why: unknown) => {
      isGivenUp = true;
      clearTimeout(timer);
      reject(why instanceof Error ? why : new Error(String(why)));
    };
    const timer = setTimeout(giveUp, patienceMs, "no answer");
    request.onupgradeneeded = () => {
      makeTables(request.result);
    };
    request.onblocked = () => {
      giveUp("blocked");
    };
    request.onerror = (event) => {
      event.preventDefault();
      giveUp(request.error);
    };
    request.onsuccess = () => {
      const database = request.result;
      const hasAll = tableNames.every((table) => database.objectStoreNames.contains(table));
      if (!isGivenUp && hasAll) {
        clearTimeout(timer);
        // Who deletes or renews the database must not wait for us; the next write opens it again.
        database.onversionchange = () => {
          database.close();
        };
        resolve(database);
        return;
      }
      database.close();
      if (!isGivenUp) giveUp("tables are missing");
    };
  });
}
