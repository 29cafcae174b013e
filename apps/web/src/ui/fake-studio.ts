// SPDX-License-Identifier: Apache-2.0
import { signal, type Signal } from "@preact/signals";
import actionsPage from "../../../../docs/ACTIONS.md?raw";
import { actionNames, type ActionName } from "../protocol/actions.generated";
import type { CoreEvent } from "../protocol/events";
import type { SaveState, SessionRow } from "../protocol/messages";
import type { ActionRow, EngineState, LayerRow, Menu } from "../protocol/state";
import { chordText } from "../studio/chords";
import { emptyState } from "../studio/empty-state";
import type { MarkSide } from "../studio/mark-side";
import type { Preferences } from "../studio/preferences";
import type { LongWork, Notice, Panel, Studio, Thumbnail } from "../studio/studio";
import { word } from "../studio/words";

/** A studio without a core, for tests of what shows it. It keeps what it was told to do. */
export interface FakeStudio extends Studio {
  readonly state: Signal<EngineState>;
  readonly saveState: Signal<SaveState>;
  readonly longWork: Signal<LongWork | null>;
  readonly notices: Signal<readonly Notice[]>;
  readonly sessions: Signal<readonly SessionRow[]>;
  readonly acts: (readonly [ActionName, string])[];
  readonly sent: CoreEvent[];
}

function isActionName(name: string): name is ActionName {
  return (actionNames as readonly string[]).includes(name);
}

const menus: readonly Menu[] = ["file", "edit", "view", "tool", "part", "model", "help"];

/** The core's table, read from the page that is printed from it. */
function actionRows(): ActionRow[] {
  let menu: Menu = "file";
  return actionsPage.split("\n").flatMap((line) => {
    const heading = /^## (\w+)/.exec(line)?.[1]?.toLowerCase();
    menu = menus.find((each) => each === heading) ?? menu;
    const [, quoted = "", en = "", cs = "", keys = ""] = line.split("|").map((cell) => cell.trim());
    const name = quoted.replace(/`/g, "");
    if (!isActionName(name)) return [];
    const chords = [...keys.matchAll(/`([^`]+)`/g)].map(([, chord = ""]) => chord);
    return [{ name, menu, labels: { en, cs }, chords, argument: "none", choices: [] }];
  });
}

export function fakeLayer(id: number, change: Partial<LayerRow> = {}): LayerRow {
  return {
    id,
    name: `Part ${id}`,
    thickness: 1,
    fill: null,
    isHidden: false,
    isLocked: false,
    isOpen: false,
    isSelected: false,
    look: id,
    ...change,
  };
}

export function fakePreferences(): Preferences {
  return {
    theme: signal("system"),
    paper: signal("light"),
    language: signal("en"),
    singleKeys: signal("on"),
    hints: signal("show"),
  };
}

type Change = (argument: string) => Partial<EngineState>;

/** What becomes of the state, as far as components show it. */
const changes: Partial<Record<ActionName, Change>> = {
  brush: () => ({ tool: "brush" }),
  help_line: () => ({ tool: "help_line" }),
  eraser: () => ({ tool: "eraser" }),
  mark: () => ({ tool: "mark" }),
  select_tool: () => ({ tool: "select" }),
  hand: () => ({ tool: "hand" }),
  mode_draw: () => ({ mode: "draw" }),
  mode_inflate: () => ({ mode: "inflate" }),
  brush_size: (px) => ({ brushPx: Number(px) }),
  ink_colour: (ink) => ({ ink }),
  gap: (px) => ({ gapPx: px === "auto" ? null : Number(px) }),
};

/** Everything can be done in it but what `change` leaves out of `enabled`. */
export function fakeStudio(change: Partial<EngineState> = {}): FakeStudio {
  const state = signal<EngineState>({ ...emptyState("en"), enabled: actionNames, ...change });
  const preferences = fakePreferences();
  const rows = actionRows();
  const row = (name: ActionName) => rows.find((each) => each.name === name);
  const acts: (readonly [ActionName, string])[] = [];
  const sent: CoreEvent[] = [];
  const thumbnail = signal<Thumbnail | null>(null);
  return {
    state,
    acts,
    sent,
    preferences,
    actions: signal(rows),
    saveState: signal<SaveState>({ kind: "saved", timeMs: 0 }),
    longWork: signal<LongWork | null>(null),
    notices: signal<readonly Notice[]>([]),
    sessions: signal<readonly SessionRow[]>([]),
    panel: signal<Panel | null>(null),
    markSide: signal<MarkSide>("outside"),
    isStarting: signal(false),
    word: (name, ...values) => word(name, preferences.language.value, ...values),
    label: (name) => row(name)?.labels[preferences.language.value] ?? name,
    chord: (name) => chordText(row(name)?.chords[0] ?? "", false),
    isEnabled: (name) => state.value.enabled.includes(name),
    act(name, argument = "") {
      acts.push([name, argument]);
      state.value = { ...state.value, ...changes[name]?.(argument) };
    },
    send: (event) => sent.push(event),
    open: () => undefined,
    exportAs: () => Promise.resolve([]),
    notify: () => undefined,
    dismiss: () => undefined,
    cancelLongWork: () => undefined,
    thumbnail: () => thumbnail,
    openSession: () => undefined,
    forgetSession: () => undefined,
    refreshSessions: () => undefined,
    rawSession: () => Promise.resolve(new Uint8Array()),
    showPlace: () => undefined,
    onFrame: () => () => undefined,
    onFiles: () => undefined,
    onOpen: () => undefined,
  };
}
