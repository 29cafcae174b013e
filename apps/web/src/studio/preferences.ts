// SPDX-License-Identifier: Apache-2.0
import { effect, signal, type Signal } from "@preact/signals";
import type { Language } from "../protocol/state";

/** How a person likes the studio; kept in this browser, in no document. */
export interface Preferences {
  readonly theme: Signal<"system" | "light" | "dark">;
  /** The paper in the dark theme. */
  readonly paper: Signal<"light" | "slate">;
  readonly language: Signal<Language>;
  /** Off: keys that type a sign do nothing without Ctrl or Alt. */
  readonly singleKeys: Signal<"on" | "off">;
  /** First-start hints: done or skipped. */
  readonly hints: Signal<"show" | "done">;
  /** What the first use of Deform is told: done or skipped. */
  readonly bendHint: Signal<"show" | "done">;
}

const choices = {
  theme: ["system", "light", "dark"],
  paper: ["light", "slate"],
  language: ["en", "cs"],
  singleKeys: ["on", "off"],
  hints: ["show", "done"],
  bendHint: ["show", "done"],
} as const;

/** Storage may be refused, or hold what another version or person has put there. */
function read(name: string): string | null {
  try {
    return localStorage.getItem(`inkflate.${name}`);
  } catch {
    return null;
  }
}

function keep(name: string, value: string): void {
  try {
    localStorage.setItem(`inkflate.${name}`, value);
  } catch {
    // Then it counts for this visit alone.
  }
}

function preference<T extends string>(name: string, allowed: readonly T[], fallback: T): Signal<T> {
  const found = read(name);
  const value = signal<T>(allowed.find((each) => each === found) ?? fallback);
  effect(() => {
    keep(name, value.value);
  });
  return value;
}

export function loadPreferences(): Preferences {
  const wanted = navigator.language.toLowerCase().startsWith("cs") ? "cs" : "en";
  return {
    theme: preference("theme", choices.theme, "system"),
    paper: preference("paper", choices.paper, "light"),
    language: preference<Language>("language", choices.language, wanted),
    singleKeys: preference("singleKeys", choices.singleKeys, "on"),
    hints: preference("hints", choices.hints, "show"),
    bendHint: preference("bendHint", choices.bendHint, "show"),
  };
}
