// SPDX-License-Identifier: Apache-2.0
import type { FileUse } from "../protocol/events";
import { isCancelled, pickersOf } from "./file-system-access";
import { acceptedFor } from "./file-types";

export interface PickedFile {
  readonly file: File;
  /** null: this browser hands out the bytes alone. */
  readonly handle: FileSystemFileHandle | null;
}

function pickByInput(accept: string): Promise<PickedFile | null> {
  return new Promise((resolve) => {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = accept;
    input.hidden = true;
    const end = (picked: PickedFile | null) => {
      input.remove();
      resolve(picked);
    };
    input.addEventListener("change", () => {
      const file = input.files?.[0];
      end(file === undefined ? null : { file, handle: null });
    });
    input.addEventListener("cancel", () => {
      end(null);
    });
    // Safari may forget one that is not in the page before anything was chosen.
    document.body.append(input);
    input.click();
  });
}

/** Asks for one file; null: none was chosen. Throws when the browser does not let it ask. */
export async function pickFile(use: FileUse, description: string): Promise<PickedFile | null> {
  const accept = acceptedFor(use);
  const pickers = pickersOf(window);
  if (pickers.showOpenFilePicker === undefined) {
    return pickByInput(Object.values(accept).flat().join(","));
  }
  try {
    const [handle] = await pickers.showOpenFilePicker({ types: [{ description, accept }] });
    return handle === undefined ? null : { file: await handle.getFile(), handle };
  } catch (error) {
    if (isCancelled(error)) return null;
    throw error;
  }
}
