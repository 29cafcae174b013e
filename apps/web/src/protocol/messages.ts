// SPDX-License-Identifier: Apache-2.0
import type { CoreEvent, ResizeInput } from "./events";
import type { SceneUpdate } from "./scene";
import type { ActionRow, EngineState, Language } from "./state";

/** What goes between the page and the worker that runs the core. */

export type Outcome<T> =
  { readonly ok: true; readonly value: T } | { readonly ok: false; readonly why: string };

export interface FileOut {
  /** A proposal, with its extension. */
  readonly name: string;
  readonly bytes: Uint8Array;
}

export interface CanvasRect {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface CoreMessage {
  readonly severity: "status" | "warning" | "problem";
  /** In the engine's language. */
  readonly text: string;
  /** On the canvas: where to look. */
  readonly place: CanvasRect | null;
}

/** Actions that the studio itself has to do. */
export type StudioRequest = "open" | "export" | "open_template" | "help" | "palette";

/** How safe the work is. */
export type SaveState =
  | { readonly kind: "saved"; readonly timeMs: number }
  | { readonly kind: "saving" }
  /** The work goes on in memory alone. */
  | { readonly kind: "refused"; readonly why: "full" | "unavailable" };

/** A drawing that an earlier run has left. */
export interface SessionRow {
  readonly id: string;
  readonly name: string;
  readonly changedMs: number;
  /** PNG; null: none was made. */
  readonly picture: Uint8Array | null;
}

/** Which drawing to go on with. */
export type StartWith =
  /** The tab's own one if it has one, else what an earlier run has left, else a new one. */
  | { readonly kind: "choose"; readonly own: string | null }
  | { readonly kind: "session"; readonly session: string }
  | { readonly kind: "new" };

export type ToWorker =
  /** First message. */
  | {
      readonly kind: "start";
      readonly wasm: WebAssembly.Module;
      readonly startWith: StartWith;
      readonly language: Language;
      /** A drawing that is taken up again is fitted into it. */
      readonly view: ResizeInput;
    }
  /** sequence: of the last event of these; ascending. */
  | { readonly kind: "events"; readonly events: readonly CoreEvent[]; readonly sequence: number }
  /** Asks for a picture of one part, at most this large; answered by "thumbnail". */
  | {
      readonly kind: "thumbnail";
      readonly layer: number;
      readonly look: number;
      readonly sizePx: number;
    }
  /** Asks for what earlier runs have left; answered by "sessions". */
  | { readonly kind: "list_sessions" }
  | { readonly kind: "forget_session"; readonly session: string }
  /** The raw bytes of a session, for when it cannot be opened; answered by "raw_session". */
  | { readonly kind: "raw_session"; readonly session: string };

/** The answer to events, in one piece. */
export interface Frame {
  readonly kind: "frame";
  /** Of the last event that has been taken in. */
  readonly sequence: number;
  /** Nothing more will come before the next event. */
  readonly isAtRest: boolean;
  /** null: looks as before. */
  readonly scene: SceneUpdate | null;
  /** null: as before. */
  readonly state: EngineState | null;
  readonly messages: readonly CoreMessage[];
  readonly files: readonly FileOut[];
  readonly requests: readonly StudioRequest[];
}

export type FromWorker =
  | {
      readonly kind: "ready";
      readonly session: string;
      readonly actions: readonly ActionRow[];
      /** Other drawings that earlier runs have left. */
      readonly sessions: readonly SessionRow[];
      /** The person may have meant one of them. */
      readonly areOthersOffered: boolean;
      /** The drawing could not be brought back whole. */
      readonly isSomethingGone: boolean;
    }
  | Frame
  /** share: 0 .. 1; null: over. Sent from the midst of long work. */
  | { readonly kind: "progress"; readonly stage: string; readonly share: number | null }
  | { readonly kind: "save_state"; readonly state: SaveState }
  | {
      readonly kind: "thumbnail";
      readonly layer: number;
      readonly look: number;
      readonly width: number;
      readonly height: number;
      /** RGBA */
      readonly pixels: Uint8ClampedArray;
    }
  | { readonly kind: "sessions"; readonly sessions: readonly SessionRow[] }
  | { readonly kind: "raw_session"; readonly session: string; readonly bytes: Uint8Array }
  /** The core has stopped; nothing more will come from this worker. */
  | { readonly kind: "fault"; readonly why: string };
