// SPDX-License-Identifier: Apache-2.0
import type { FileOut } from "../protocol/messages";
import type { Word } from "../studio/words";
import { isCancelled, pickersOf } from "./file-system-access";
import { extensionOf, mimeTypeOf } from "./file-types";

/** The browser reads a blob's address for a while after the click. */
const keepBlobMs = 60_000;

export function fileOf(out: FileOut): File {
  return new File([out.bytes as Uint8Array<ArrayBuffer>], out.name, {
    type: mimeTypeOf(out.name),
  });
}

/** Gives the file to the browser's downloads. */
export function download(out: FileOut): void {
  const url = URL.createObjectURL(fileOf(out));
  const link = document.createElement("a");
  link.href = url;
  link.download = out.name;
  link.click();
  setTimeout(() => {
    URL.revokeObjectURL(url);
  }, keepBlobMs);
}

/** The file is as it was until all is written. */
export async function writeTo(handle: FileSystemFileHandle, out: FileOut): Promise<void> {
  const stream = await handle.createWritable();
  try {
    await stream.write(out.bytes as Uint8Array<ArrayBuffer>);
  } catch (error) {
    await stream.abort().catch(() => undefined);
    throw error;
  }
  await stream.close();
}

export function hasSavePicker(): boolean {
  return pickersOf(window).showSaveFilePicker !== undefined;
}

/** Asks where to; null: nowhere. Throws when the browser does not let it ask. */
export async function pickTarget(
  name: string,
  description: string,
): Promise<FileSystemFileHandle | null> {
  try {
    const handle = await pickersOf(window).showSaveFilePicker?.({
      suggestedName: name,
      types: [{ description, accept: { [mimeTypeOf(name)]: [extensionOf(name)] } }],
    });
    return handle ?? null;
  } catch (error) {
    if (isCancelled(error)) return null;
    throw error;
  }
}

const reasons: Readonly<Record<string, Word>> = {
  NotAllowedError: "save_forbidden",
  SecurityError: "save_forbidden",
  NoModificationAllowedError: "save_locked",
  InvalidStateError: "save_locked",
  NotFoundError: "save_gone",
  QuotaExceededError: "save_full",
};

/** Why a file could not be written, in words for people. */
export function reasonOf(error: unknown): Word {
  const name = error instanceof Error || error instanceof DOMException ? error.name : "";
  return reasons[name] ?? "save_unknown";
}
