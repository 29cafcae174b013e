// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { ActionName } from "../protocol/actions.generated";
import type { Word } from "../studio/words";
import "../styles/hints.css";
import {
  advanceHints,
  bendHint,
  hintSteps,
  hintToShow,
  isBending,
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
  return <span>{chord === "" ? studio.word(withoutKey) : studio.word(withKey, chord)}</span>;
}

interface HintCardProps {
  readonly text: ComponentChildren;
  /** How far along the way; before the text. */
  readonly dots?: ComponentChildren;
  readonly onSkip: () => void;
}

/** Steps aside while a hand is at work. */
function HintCard({ text, dots, onSkip }: HintCardProps) {
  const studio = useStudio();
  const isDrawing = useCanvasPress();
  return (
    <aside class="hint under-head" data-away={isDrawing} aria-label={studio.word("hints")}>
      {dots}
      <p class="hint-text" role="status">
        {text}
      </p>
      <button type="button" class="hint-skip" onClick={onSkip}>
        {studio.word("skip_hints")}
      </button>
    </aside>
  );
}

/** One line, the first time that something could be bent. */
function BendHint() {
  const studio = useStudio();
  const { bendHint: wanted } = studio.preferences;
  const now = bendHint(studio.state.value);
  useEffect(() => {
    if (now === "known") wanted.value = "done";
  }, [now, wanted]);
  if (now !== "show" && now !== "simplify") return null;
  const word = now === "show" ? "hint_bend" : "hint_bend_rough";
  return (
    <HintCard
      text={<span key={word}>{studio.word(word)}</span>}
      onSkip={() => {
        wanted.value = "done";
      }}
    />
  );
}

interface FirstDrawingHintProps {
  /** It is not the time to speak of it. */
  readonly isAside: boolean;
}

function FirstDrawingHint({ isAside }: FirstDrawingHintProps) {
  const studio = useStudio();
  const [progress, setProgress] = useState<HintProgress>(0);
  const isTurned = useModelTurned(studio);
  const facts = { state: studio.state.value, isTurned };
  const advanced = advanceHints(progress, facts);

  useEffect(() => {
    setProgress(advanced);
    if (advanced < hintSteps.length) return;
    studio.preferences.hints.value = "done";
    studio.notify("status", studio.word("hint_finished"));
  }, [advanced, studio]);

  const step = hintToShow(advanced, facts);
  if (step === null || isAside) return null;
  const dots = (
    <span class="hint-dots" aria-hidden="true">
      {hintSteps.map((each, index) => (
        <span key={each} data-done={index < advanced} data-now={each === step} />
      ))}
    </span>
  );
  return (
    <HintCard
      text={<HintText key={step} step={step} />}
      dots={dots}
      onSkip={() => {
        studio.preferences.hints.value = "done";
      }}
    />
  );
}

/** A word along the way of the first drawing; it follows what the person does and never asks for it. */
export function Hints() {
  const studio = useStudio();
  const { hints, bendHint: ofDeform } = studio.preferences;
  const isAside = isBending(studio.state.value);
  if (studio.isStarting.value) return null;
  return (
    <>
      {isAside && ofDeform.value === "show" && <BendHint />}
      {hints.value === "show" && <FirstDrawingHint isAside={isAside} />}
    </>
  );
}
