// SPDX-License-Identifier: Apache-2.0
import { AutoSlider } from "./auto-slider";
import { ActionButton } from "./icon-button";
import {
  AddPinIcon,
  AdjustIcon,
  DeleteIcon,
  FreePinIcon,
  RemovePinsIcon,
  TurnPinLeftIcon,
  TurnPinRightIcon,
} from "./icons";
import { isNarrow } from "./narrow";
import { Popover } from "./popover";
import { evenScale, ratioScale } from "./scales";
import { Slider } from "./slider";
import { useStudio } from "./studio-context";
import { SwitchRow } from "./switch-row";

/** Of the core: BendOptions, ToolSettings. Equal ways bend equally differently. */
const bodyScale = ratioScale(0.003, 1);
const reachScale = evenScale(0.02, 1);

/** How stiff the inside is beside the line. The strip has no inside. */
function BodyOrWire() {
  const studio = useStudio();
  const { bendMode, bendBody } = studio.state.value;
  if (bendMode === "wire") return <p class="context-hint">{studio.word("as_strip")}</p>;
  const ends = [studio.word("bend_wire"), studio.word("bend_body")] as const;
  const text = (value: number) => {
    const share = Math.round(bodyScale.toPosition(value));
    if (share === 0) return ends[0];
    return share === 100 ? ends[1] : studio.word("bend_share", share);
  };
  return (
    <Slider
      label={studio.label("bend_body")}
      value={bendBody}
      scale={bodyScale}
      text={text}
      ends={ends}
      onInput={(value) => {
        studio.act("bend_body", String(value));
      }}
    />
  );
}

/** How much of the part follows a drag. */
function Reach() {
  const studio = useStudio();
  return (
    <AutoSlider
      label={studio.word("reach")}
      value={studio.state.value.bendReach}
      rest={studio.state.value.usualReach}
      scale={reachScale}
      text={(value) =>
        value === 1 ? studio.word("whole_part") : studio.word("percent", Math.round(100 * value))
      }
      autoTip={studio.word("auto_reach")}
      onChange={(value) => {
        studio.act("bend_reach", value === null ? "auto" : String(value));
      }}
    />
  );
}

function StripSwitch() {
  const studio = useStudio();
  return (
    <SwitchRow
      label={studio.word("as_strip")}
      note={studio.word("as_strip_note")}
      isOn={studio.state.value.bendMode === "wire"}
      onSwitch={(isOn) => {
        studio.act("bend_mode", isOn ? "wire" : "body");
      }}
    />
  );
}

/** In words, where there is no room for it in the row. */
function RemovePins() {
  const studio = useStudio();
  return (
    <button
      type="button"
      class="plain-button"
      aria-disabled={!studio.isEnabled("delete_pins")}
      onClick={() => {
        studio.act("delete_pins");
      }}
    >
      {studio.label("delete_pins")}
    </button>
  );
}

/** Pins hold the drawing where they are. */
function Pins() {
  const studio = useStudio();
  const { pins, hasPin } = studio.state.value;
  return (
    <div class="context-icons">
      <ActionButton icon={AddPinIcon} action="add_pin" />
      {hasPin && (
        <>
          <ActionButton icon={TurnPinLeftIcon} action="turn_pin_left" />
          <ActionButton icon={TurnPinRightIcon} action="turn_pin_right" />
          <ActionButton icon={FreePinIcon} action="free_pin" />
          <ActionButton
            icon={DeleteIcon}
            action="delete"
            label={studio.word("delete_pin")}
            tone="danger"
          />
        </>
      )}
      {pins > 0 && !isNarrow.value && <ActionButton icon={RemovePinsIcon} action="delete_pins" />}
    </div>
  );
}

/** How the line that one drags bends, and what holds it. */
export function DeformSettings() {
  const studio = useStudio();
  return (
    <>
      <BodyOrWire />
      {!isNarrow.value && <Reach />}
      <Pins />
      <Popover icon={AdjustIcon} label={studio.word("bend_more")}>
        {isNarrow.value && <Reach />}
        <StripSwitch />
        {isNarrow.value && studio.state.value.pins > 0 && <RemovePins />}
      </Popover>
    </>
  );
}
