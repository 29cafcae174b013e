// SPDX-License-Identifier: Apache-2.0
import type { FileUse } from "../protocol/events";
import type { Studio } from "../studio/studio";
import { isPicture, mostFileBytes } from "./file-types";
import { saverOf } from "./saver";
import { receptionOf, type Reception } from "./uninvited";

type Offer = NonNullable<Reception["offer"]>;

const megabyte = 1024 * 1024;

/** Says so when a file is larger than what is taken. */
function isTooLarge(studio: Studio, file: File): boolean {
  if (file.size <= mostFileBytes) return false;
  const has = Math.ceil(file.size / megabyte);
  studio.notify("problem", studio.word("file_too_large", file.name, has, mostFileBytes / megabyte));
  return true;
}

/**
 * Hands a file to the core: the one way for all of them. A project that is opened and has a handle is saved to it from then on.
 */
export function openFile(
  studio: Studio,
  file: File,
  use: FileUse,
  handle: FileSystemFileHandle | null = null,
): void {
  if (isTooLarge(studio, file)) return;
  if (use === "open") saverOf(studio).opening(handle);
  studio.open(file, use);
}

function undoNameOf(use: FileUse): "open" | "open_template" {
  return use === "template" ? "open_template" : "open";
}

/** Takes in files that nobody has asked for: dropped, pasted. */
export class Incoming {
  private stopWatching: () => void = () => undefined;

  constructor(private readonly studio: Studio) {}

  /** The first finds its place by what is there; the others come to it. */
  take(files: readonly File[]): void {
    const [first, ...others] = files.filter((file) => !isTooLarge(this.studio, file));
    if (first === undefined) return;
    const { isBlank } = this.studio.state.peek();
    const { use, offer } = receptionOf({ isPicture: isPicture(first), isBlank });
    if (offer !== null && others.length === 0) this.offerWhenTaken(first, use, offer);
    openFile(this.studio, first, use);
    for (const other of others) openFile(this.studio, other, "add");
  }

  /** The core may refuse the file: then it says why, and there is nothing to offer. */
  private offerWhenTaken(file: File, use: FileUse, offer: Offer): void {
    const { studio } = this;
    this.stopWatching();
    this.stopWatching = studio.onFrame((frame) => {
      const isRefused = frame.messages.some(({ severity }) => severity === "problem");
      const isTaken = frame.state?.undo === undoNameOf(use);
      if (isRefused || isTaken) this.stopWatching();
      if (isTaken) this.offer(file, use, offer);
    });
  }

  private offer(file: File, use: FileUse, offer: Offer): void {
    const { studio } = this;
    studio.notify("status", studio.word(offer.told, file.name), {
      label: studio.word(offer.label),
      run: () => {
        // Only while nothing else was done since.
        if (studio.state.peek().undo === undoNameOf(use)) studio.act("undo");
        openFile(studio, file, offer.use);
      },
    });
  }
}
