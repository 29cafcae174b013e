// SPDX-License-Identifier: Apache-2.0
import { ratioScale } from "./scales";
import { Slider } from "./slider";
import { useStudio } from "./studio-context";
import "../styles/gap-slider.css";

/** px of the canvas: from the width of a thin line to a third of a sheet. */
const scale = ratioScale(2, 300);
/** Where the slider stands while the core finds the gap by itself. */
const restPx = 24;

/** The largest gap that Simplify closes: as the drawing suggests, or as the person says. */
export function GapSlider() {
  const studio = useStudio();
  const { gapPx } = studio.state.value;
  const isAuto = gapPx === null;
  return (
    <div class="gap-slider" data-is-auto={isAuto}>
      <Slider
        label={studio.word("gap")}
        value={gapPx ?? restPx}
        scale={scale}
        text={(value) => studio.word("px", value)}
        onInput={(value) => {
          studio.act("gap", String(value));
        }}
      />
      <button
        type="button"
        class="toggle"
        aria-pressed={isAuto}
        data-tip={studio.word("auto_gap")}
        onClick={() => {
          studio.act("gap", isAuto ? String(restPx) : "auto");
        }}
      >
        {studio.word("auto")}
      </button>
    </div>
  );
}
