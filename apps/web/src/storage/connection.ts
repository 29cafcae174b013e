// SPDX-License-Identifier: Apache-2.0
import { openDatabase, transact, type TableName } from "./database";

/** A database that is opened again when the browser has closed it (its data were cleared, its process has died). */
export class Connection {
  private constructor(
    private readonly factory: IDBFactory,
    private readonly name: string,
    private database: IDBDatabase,
  ) {}

  /** Takes the first of the names that can be opened; rejects where none can. */
  static async open(factory: IDBFactory, names: readonly string[]): Promise<Connection> {
    let fault: unknown = new Error("no name");
    for (const name of names) {
      try {
        return new Connection(factory, name, await openDatabase(factory, name));
      } catch (error) {
        fault = error;
      }
    }
    throw fault;
  }

  async read<T>(work: (table: (name: TableName) => IDBObjectStore) => Promise<T>): Promise<T> {
    return this.run("readonly", work);
  }

  async write<T>(work: (table: (name: TableName) => IDBObjectStore) => Promise<T>): Promise<T> {
    return this.run("readwrite", work);
  }

  private async run<T>(
    mode: "readonly" | "readwrite",
    work: (table: (name: TableName) => IDBObjectStore) => Promise<T>,
  ): Promise<T> {
    try {
      return await transact(this.database, mode, work);
    } catch (error) {
      const isLost = error instanceof DOMException && lostNames.includes(error.name);
      if (!isLost) throw error;
    }
    this.database.close();
    this.database = await openDatabase(this.factory, this.name);
    return transact(this.database, mode, work);
  }
}

/** InvalidStateError: closed before; AbortError, UnknownError: closed in the midst of it. */
const lostNames = ["InvalidStateError", "AbortError", "UnknownError"];
