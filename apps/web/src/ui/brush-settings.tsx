// SPDX-License-Identifier: Apache-2.0
import { AdjustIcon } from "./icons";
import { isNarrow } from "./narrow";
import { Popover } from "./popover";
import { evenScale, ratioScale } from "./scales";
import { Slider } from "./slider";
import { useStudio } from "./studio-context";
import { Swatches, type Swatch } from "./swatches";

/** What a drawing needs: a black, and five that stay apart from each other when the model turns. */
const inks: readonly Swatch[] = [
  { colour: "#22242b", name: "ink_black" },
  { colour: "#7b4a2e", name: "ink_brown" },
  { colour: "#c8372d", name: "ink_red" },
  { colour: "#e0a12b", name: "ink_yellow" },
  { colour: "#4b8b43", name: "ink_green" },
  { colour: "#2f5fb3", name: "ink_blue" },
];

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

function Inks() {
  const studio = useStudio();
  return (
    <Swatches
      label={studio.label("ink_colour")}
      swatches={inks}
      chosen={studio.state.value.ink}
      onChoose={(colour) => {
        studio.act("ink_colour", colour);
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
  return (
    <>
      <BrushSize />
      {isNarrow.value ? (
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
