// SPDX-License-Identifier: Apache-2.0
import type { Answer, BlobPlace } from "./answer";
import type { EngineChanges } from "./engine-changes";

export type ChangesHead = Omit<EngineChanges, "files" | "journal"> & {
  readonly files: readonly { readonly name: string; readonly bytes: BlobPlace }[];
  readonly journal: BlobPlace;
};

/** The changes of an answer. Files and journal go different ways, so each has its own buffer. */
export function readChanges(answer: Answer<ChangesHead>): EngineChanges {
  const { head } = answer;
  return {
    ...head,
    files: head.files.map(({ name, bytes }) => ({ name, bytes: answer.ownBytes(bytes) })),
    journal: answer.ownBytes(head.journal),
  };
}
