// SPDX-License-Identifier: Apache-2.0
import type { ReadonlySignal, Signal } from "@preact/signals";
import type { ActionName } from "../protocol/actions.generated";
import type { CoreEvent, FileUse } from "../protocol/events";
import type { CanvasRect, FileOut, Frame, SaveState, SessionRow } from "../protocol/messages";
import type { ActionRow, EngineState } from "../protocol/state";
import type { MarkSide } from "./mark-side";
import type { Preferences } from "./preferences";
import type { Word } from "./words";

/** What the studio says to the person: shown for a while, and read out. */
export interface Notice {
  readonly id: number;
  readonly severity: "status" | "warning" | "problem";
  readonly text: string;
  /** On the canvas: "Show" goes there. */
  readonly place: CanvasRect | null;
  /** One thing that can be done about it. */
  readonly remedy: { readonly label: string; readonly run: () => void } | null;
}

export interface LongWork {
  readonly stage: string;
  /** 0 .. 1 */
  readonly share: number;
}

/** Panels over the canvas; at most one is open. */
export type Panel =
  "menu" | "help" | "export" | "palette" | "gallery" | "settings" | "sessions" | "parts";

export interface Thumbnail {
  readonly look: number;
  readonly image: ImageData;
}

/** Everything that the face of the studio shows and can do. Components get it by useStudio(). */
export interface Studio {
  readonly state: ReadonlySignal<EngineState>;
  readonly actions: ReadonlySignal<readonly ActionRow[]>;
  readonly saveState: ReadonlySignal<SaveState>;
  /** Work of more than 100 ms; null: none. */
  readonly longWork: ReadonlySignal<LongWork | null>;
  readonly notices: ReadonlySignal<readonly Notice[]>;
  /** Drawings that earlier runs have left and nobody holds. */
  readonly sessions: ReadonlySignal<readonly SessionRow[]>;
  readonly panel: Signal<Panel | null>;
  /** What the mark tool says of the places that are clicked. */
  readonly markSide: Signal<MarkSide>;
  readonly preferences: Preferences;
  /** Is true while the page has no core: at the start, and after a fault until it is back. */
  readonly isStarting: ReadonlySignal<boolean>;

  /** The studio's own words. */
  word(name: Word, ...values: (string | number)[]): string;
  /** The action's name for people. */
  label(name: ActionName): string;
  /** The first of its keys as people of this system write it; "": none. */
  chord(name: ActionName): string;
  isEnabled(name: ActionName): boolean;

  /** Does an action of the core's table. Requests of the core (open, export, help, ...) come back through `panel` and files/. */
  act(name: ActionName, argument?: string): void;
  /** Returns the event's number; a frame tells up to which number it has taken events in. */
  send(event: CoreEvent): number;
  open(file: File, use: FileUse): void;
  /** Files of one action, taken from the stream of frames instead of being offered for saving. */
  exportAs(extension: string): Promise<readonly FileOut[]>;

  notify(severity: Notice["severity"], text: string, remedy?: Notice["remedy"]): void;
  dismiss(id: number): void;
  cancelLongWork(): void;

  thumbnail(layer: number, look: number): ReadonlySignal<Thumbnail | null>;
  openSession(session: string | null): void;
  forgetSession(session: string): void;
  refreshSessions(): void;
  rawSession(session: string): Promise<Uint8Array>;

  /** Brings a place of the canvas into view. */
  showPlace(place: CanvasRect): void;

  /** Calls back with every frame of the core, before the signals change. Returns how to stop. */
  onFrame(listener: (frame: Frame) => void): () => void;
  /** Files that the core wants saved (Ctrl+S). Set by files/. */
  onFiles: (files: readonly FileOut[]) => void;
  /** Requests to open files. Set by files/. */
  onOpen: (use: FileUse) => void;
}
