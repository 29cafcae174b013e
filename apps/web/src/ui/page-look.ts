// SPDX-License-Identifier: Apache-2.0
import { effect } from "@preact/signals";
import type { Preferences } from "../studio/preferences";

/** Tells the page's root what tokens.css and screen readers go by. Returns how to stop. */
export function followPreferences({ theme, paper, language }: Preferences): () => void {
  const root = document.documentElement;
  return effect(() => {
    root.dataset.theme = theme.value;
    root.dataset.paper = paper.value;
    root.lang = language.value;
  });
}
