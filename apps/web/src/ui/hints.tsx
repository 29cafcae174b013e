// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";
import type { ActionName } from "../protocol/actions.generated";
import type { Word } from "../studio/words";
import "../styles/hints.css";
import {
  advanceHints,
  hintSteps,
  hintToShow,
  type HintProgress,
  type HintStep,
} from "./hint-steps";
import { isCoarse } from "./narrow";
import { useStudio } from "./studio-context";
import { useModelTurned } from "./use-model-turned";
import { useCanvasPress } from "./use-canvas-press";

interface StepWords {
  /** Its key is named where there is one to press; {0}. */
  readonly action: ActionName | null;
  readonly withKey: Word;
  readonly withoutKey: Word;
}

const stepWords: Readonly<Record<HintStep, StepWords>> = {
  draw: { action: null, withKey: "hint_draw", withoutKey: "hint_draw" },
  simplify: { action: "simplify", withKey: "hint_simplify_key", withoutKey: "hint_simplify" },
  inflate: { action: "mode_inflate", withKey: "hint_inflate_key", withoutKey: "hint_inflate" },
  turn: { action: null, withKey: "hint_turn", withoutKey: "hint_turn" },
};

function HintText({ step }: { readonly step: HintStep }) {
  const studio = useStudio();
  const { action, withKey, withoutKey } = stepWords[step];
  const areKeysOn = studio.preferences.singleKeys.value === "on";
  const chord = action === null || isCoarse.value || !areKeysOn ? "" : studio.chord(action);
  return <>{chord === "" ? studio.word(withoutKey) : studio.word(withKey, chord)}</>;
}

function HintCard() {
  const studio = useStudio();
  const [progress, setProgress] = useState<HintProgress>(0);
  const isTurned = useModelTurned(studio);
  const isDrawing = useCanvasPress();
  const facts = { state: studio.state.value, isTurned };
  const advanced = advanceHints(progress, facts);

  useEffect(() => {
    setProgress(advanced);
    if (advanced < hintSteps.length) return;
    studio.preferences.hints.value = "done";
    studio.notify("status", studio.word("hint_finished"));
  }, [advanced, studio]);

  const step = hintToShow(advanced, facts);
  if (step === null) return null;
  return (
    <aside class="hint under-head" data-away={isDrawing} aria-label={studio.word("hints")}>
      <span class="hint-dots" aria-hidden="true">
        {hintSteps.map((each, index) => (
          <span key={each} data-done={index < advanced} data-now={each === step} />
        ))}
      </span>
      <p key={step} class="hint-text" role="status">
        <HintText step={step} />
      </p>
      <button
        type="button"
        class="hint-skip"
        onClick={() => {
          studio.preferences.hints.value = "done";
        }}
      >
        {studio.word("skip_hints")}
      </button>
    </aside>
  );
}

/** A word along the way of the first drawing; it follows what the person does and never asks for it. */
export function Hints() {
  const studio = useStudio();
  if (studio.preferences.hints.value === "done" || studio.isStarting.value) return null;
  return <HintCard />;
}
