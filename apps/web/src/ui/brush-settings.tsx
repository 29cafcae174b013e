// SPDX-License-Identifier: Apache-2.0
import { AdjustIcon } from "./icons";
import { Popover } from "./popover";
import { evenScale, ratioScale } from "./scales";
import { Slider } from "./slider";
import { useStudio } from "./studio-context";
import { narrowWindow, useMedia } from "./use-media";
import { Inks } from "./inks";

/** Of the core: ToolSettings. */
const brushScale = ratioScale(0.5, 100);
const eraserScale = ratioScale(1, 200);
const smoothingScale = evenScale(0, 1);

export function BrushSize() {
  const studio = useStudio();
  return (
    <Slider
      label={studio.word("size")}
      value={studio.state.value.brushPx}
      scale={brushScale}
      text={(value) => studio.word("px", Math.round(value * 10) / 10)}
      onInput={(value) => {
        studio.act("brush_size", String(value));
      }}
    />
  );
}

export function EraserSize() {
  const studio = useStudio();
  return (
    <Slider
      label={studio.word("size")}
      value={studio.state.value.eraserPx}
      scale={eraserScale}
      text={(value) => studio.word("px", Math.round(value * 10) / 10)}
      onInput={(value) => {
        studio.act("eraser_size", String(value));
      }}
    />
  );
}

function Smoothing() {
  const studio = useStudio();
  return (
    <Slider
      label={studio.label("smoothing")}
      value={studio.state.value.smoothing}
      scale={smoothingScale}
      text={(value) => studio.word("percent", Math.round(100 * value))}
      onInput={(value) => {
        studio.act("smoothing", String(value));
      }}
    />
  );
}

/** The ink that the brush has. */
function InkDot() {
  const studio = useStudio();
  return <span class="ink-dot" style={{ "--swatch": studio.state.value.ink }} aria-hidden="true" />;
}

export function BrushSettings() {
  const studio = useStudio();
  const isNarrow = useMedia(narrowWindow);
  return (
    <>
      <BrushSize />
      {isNarrow ? (
        <Popover icon={InkDot} label={studio.label("ink_colour")}>
          <Inks />
        </Popover>
      ) : (
        <Inks />
      )}
      <Popover icon={AdjustIcon} label={studio.label("smoothing")}>
        <Smoothing />
      </Popover>
    </>
  );
}
