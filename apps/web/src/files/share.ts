// SPDX-License-Identifier: Apache-2.0
import type { FileOut } from "../protocol/messages";
import { isCancelled } from "./file-system-access";
import { fileOf } from "./write-file";

/** Whether this device's own sheet of apps takes such files. */
export function canShare(files: readonly FileOut[]): boolean {
  const has = navigator as { canShare?: (data: ShareData) => boolean };
  return files.length > 0 && (has.canShare?.({ files: files.map(fileOf) }) ?? false);
}

/** Throws when the other app could not be given them. */
export async function share(files: readonly FileOut[]): Promise<void> {
  try {
    await navigator.share({ files: files.map(fileOf) });
  } catch (error) {
    if (!isCancelled(error)) throw error;
  }
}
