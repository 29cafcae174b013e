// SPDX-License-Identifier: Apache-2.0
// The parts of the File System Access API, Launch Handler and Clipboard that TypeScript does not know. Not every browser has them.

export interface FileTypeChoice {
  readonly description: string;
  readonly accept: Readonly<Record<string, readonly string[]>>;
}

interface PickerOptions {
  readonly types: readonly FileTypeChoice[];
  readonly excludeAcceptAllOption?: boolean;
}

export interface FileSystemPickers {
  showOpenFilePicker?(options: PickerOptions): Promise<FileSystemFileHandle[]>;
  showSaveFilePicker?(
    options: PickerOptions & { readonly suggestedName: string },
  ): Promise<FileSystemFileHandle>;
}

interface LaunchParameters {
  readonly files: readonly FileSystemFileHandle[];
}

export interface LaunchWindow {
  readonly launchQueue?: {
    setConsumer(consumer: (parameters: LaunchParameters) => void): void;
  };
}

export function pickersOf(page: unknown): FileSystemPickers {
  return page as FileSystemPickers;
}

/** The person has changed their mind. */
export function isCancelled(error: unknown): boolean {
  return error instanceof DOMException && error.name === "AbortError";
}
