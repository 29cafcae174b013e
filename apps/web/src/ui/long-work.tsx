// SPDX-License-Identifier: Apache-2.0
import { useId } from "preact/hooks";
import "../styles/long-work.css";
import { stageWord } from "./stage-words";
import { useStudio } from "./studio-context";

/** What the core is at when it takes longer, how far it has come, and how to stop it. */
export function LongWorkBar() {
  const studio = useStudio();
  const labelId = useId();
  const work = studio.longWork.value;
  if (work === null) return null;
  return (
    <section class="long-work under-head surface-raised" aria-labelledby={labelId}>
      <span id={labelId} class="long-work-stage">
        {studio.word(stageWord(work.stage))}
      </span>
      <progress class="long-work-bar" aria-labelledby={labelId} max={1} value={work.share} />
      <button
        type="button"
        class="long-work-cancel"
        onClick={() => {
          studio.cancelLongWork();
        }}
      >
        {studio.label("cancel")}
      </button>
    </section>
  );
}
