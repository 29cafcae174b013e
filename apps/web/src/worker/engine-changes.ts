// SPDX-License-Identifier: Apache-2.0
import type { CoreMessage, FileOut, StudioRequest } from "../protocol/messages";

/** What events have changed since it was last asked: src/editor/engine.h, Changes. */
export interface EngineChanges {
  readonly isSceneChanged: boolean;
  readonly isDocumentChanged: boolean;
  readonly isStateChanged: boolean;
  readonly messages: readonly CoreMessage[];
  readonly files: readonly FileOut[];
  readonly requests: readonly StudioRequest[];
  /** To be appended to the journal; bytes of UTF-8. */
  readonly journal: Uint8Array;
  /** The journal starts anew with these bytes. */
  readonly isJournalNew: boolean;
  /** Each byte of the journal that was read last counts, so that more can be appended to it. Only after recover(). */
  readonly isRecoveredWhole: boolean;
}
