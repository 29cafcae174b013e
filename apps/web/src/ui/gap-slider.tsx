// SPDX-License-Identifier: Apache-2.0
import { AutoSlider } from "./auto-slider";
import { ratioScale } from "./scales";
import { useStudio } from "./studio-context";

/** px of the canvas: from the width of a thin line to a third of a sheet. */
const scale = ratioScale(2, 300);
const restPx = 24;

/** The largest gap that Simplify closes. */
export function GapSlider() {
  const studio = useStudio();
  return (
    <AutoSlider
      label={studio.word("gap")}
      value={studio.state.value.gapPx}
      rest={restPx}
      scale={scale}
      text={(value) => studio.word("px", value)}
      autoTip={studio.word("auto_gap")}
      onChange={(value) => {
        studio.act("gap", value === null ? "auto" : String(value));
      }}
    />
  );
}
