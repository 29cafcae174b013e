// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";
import type { SaveState } from "../protocol/messages";
import type { Studio } from "../studio/studio";
import { CheckIcon, SavingIcon, WarningIcon } from "./icons";
import { useStudio } from "./studio-context";
import "../styles/save-mark.css";

/** Saving that is over sooner is not worth a flicker. */
const quietMs = 600;

/** The state of saving without what lasts but a moment. */
function useCalm(state: SaveState): SaveState {
  const [shown, show] = useState<SaveState>(state);
  useEffect(() => {
    if (state.kind !== "saving") {
      show(state);
      return undefined;
    }
    const timer = setTimeout(() => {
      show(state);
    }, quietMs);
    return () => {
      clearTimeout(timer);
    };
  }, [state]);
  return shown;
}

function textOf(studio: Studio, state: SaveState): string {
  if (state.kind !== "refused") return studio.word(state.kind);
  return studio.word(state.why === "full" ? "not_saved_full" : "not_saved_unavailable");
}

const icons = { saved: CheckIcon, saving: SavingIcon, refused: WarningIcon } as const;

/** How safe the work is: a quiet sign with its words. */
export function SaveMark() {
  const studio = useStudio();
  const state = useCalm(studio.saveState.value);
  const Picture = icons[state.kind];
  return (
    <span class="save-mark" data-kind={state.kind}>
      <Picture aria-hidden="true" />
      <span class="save-words">{textOf(studio, state)}</span>
    </span>
  );
}
