// SPDX-License-Identifier: Apache-2.0
import type { FileUse } from "../protocol/events";
import type { Word } from "../studio/words";

/** What becomes of a file that was dropped or pasted, and what else is offered for it. */
export interface Reception {
  readonly use: FileUse;
  /** null: it is plain to see. */
  readonly offer: {
    /** Says what was done; {0} is the file's name. */
    readonly told: Word;
    readonly label: Word;
    readonly use: FileUse;
  } | null;
}

/**
 * Nobody is asked before: a file is taken in the way that loses nothing, and the other way is offered. Either can be undone.
 * A picture on an empty sheet is most likely a scan to work on; beside a drawing it is one to trace.
 */
export function receptionOf(is: {
  readonly isPicture: boolean;
  readonly isBlank: boolean;
}): Reception {
  if (is.isPicture && is.isBlank) {
    return {
      use: "open",
      offer: { told: "file_is_traced", label: "use_as_reference", use: "template" },
    };
  }
  if (is.isPicture) {
    return {
      use: "template",
      offer: { told: "file_is_reference", label: "trace_lines", use: "add" },
    };
  }
  if (is.isBlank) return { use: "open", offer: null };
  return { use: "add", offer: { told: "file_is_added", label: "open_instead", use: "open" } };
}
