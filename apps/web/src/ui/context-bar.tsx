// SPDX-License-Identifier: Apache-2.0
import type { EngineState } from "../protocol/state";
import { BrushSettings, BrushSize, EraserSize } from "./brush-settings";
import { DeformSettings } from "./deform-settings";
import { useEdgeHeight } from "./edge-heights";
import { GapSlider } from "./gap-slider";
import { HandSettings } from "./hand-settings";
import { ModelSettings } from "./model-settings";
import { PartSettings } from "./part-settings";
import { PrimaryButton } from "./primary-button";
import { Segmented } from "./segmented";
import { useStudio } from "./studio-context";
import "../styles/context-bar.css";

function MarkSettings() {
  const studio = useStudio();
  const side = studio.markSide.value;
  return (
    <>
      <Segmented
        label={studio.label("mark")}
        chosen={side}
        segments={[
          { value: "outside", label: studio.word("mark_side_outside") },
          { value: "inside", label: studio.word("mark_side_inside") },
        ]}
        onChoose={(next) => {
          studio.markSide.value = next;
        }}
      />
      <p class="context-hint">
        {studio.word(side === "outside" ? "mark_outside_hint" : "mark_inside_hint")}
      </p>
      {!studio.state.value.hasRoughStrokes && studio.isEnabled("gap") && <GapSlider />}
    </>
  );
}

function ToolSettings({ state }: { readonly state: EngineState }) {
  if (state.mode !== "draw") return <ModelSettings />;
  switch (state.tool) {
    case "brush":
      return <BrushSettings />;
    case "help_line":
      return <BrushSize />;
    case "eraser":
      return <EraserSize />;
    case "mark":
      return <MarkSettings />;
    case "select":
      return <PartSettings />;
    case "deform":
      return <DeformSettings />;
    case "hand":
      return <HandSettings />;
  }
}

/** What one most likely wants to do next; null: draw. */
function NextStep({ state }: { readonly state: EngineState }) {
  if (state.mode !== "draw") return null;
  if (state.hasRoughStrokes) {
    return (
      <div class="context-next surface">
        <GapSlider />
        <PrimaryButton action="simplify" />
      </div>
    );
  }
  if (state.layers.length === 0) return null;
  return (
    <div class="context-next">
      <PrimaryButton action="mode_inflate" />
    </div>
  );
}

/** Only what belongs to the tool, the selection and the moment. */
export function ContextBar() {
  const studio = useStudio();
  const state = studio.state.value;
  return (
    <section
      ref={useEdgeHeight<HTMLElement>("foot")}
      class="context-bar"
      aria-label={studio.word("tool_settings")}
      data-tip-side="top"
    >
      <div class="context-settings surface" key={state.mode === "draw" ? state.tool : state.mode}>
        <ToolSettings state={state} />
      </div>
      <NextStep state={state} />
    </section>
  );
}
