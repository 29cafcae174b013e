// SPDX-License-Identifier: Apache-2.0
import { ColourSwatches } from "./colour-swatches";
import { ActionButton } from "./icon-button";
import {
  AdjustIcon,
  DeleteIcon,
  DuplicateIcon,
  EditLinesIcon,
  FartherIcon,
  FlipHorizontalIcon,
  FlipVerticalIcon,
  NearerIcon,
} from "./icons";
import { Popover } from "./popover";
import { Slider, type Scale } from "./slider";
import { useStudio } from "./studio-context";
import { stepOf, thicknessAt } from "./thickness-scale";

const thicknessScale: Scale = { toPosition: stepOf, toValue: thicknessAt };

function Thickness({ value }: { readonly value: number }) {
  const studio = useStudio();
  return (
    <Slider
      label={studio.label("thickness")}
      value={value}
      scale={thicknessScale}
      text={(thickness) => studio.word("times", thickness)}
      onInput={(thickness) => {
        studio.act("thickness", String(thickness));
      }}
    />
  );
}

/** What can be done to the parts that are selected. */
export function PartSettings() {
  const studio = useStudio();
  const first = studio.state.value.layers.find((layer) => layer.isSelected);
  if (first === undefined) return <p class="context-hint">{studio.word("select_hint")}</p>;
  return (
    <div class="context-icons">
      <ActionButton icon={DuplicateIcon} action="duplicate" />
      <ActionButton icon={FlipHorizontalIcon} action="flip_horizontal" />
      <ActionButton icon={FlipVerticalIcon} action="flip_vertical" />
      <ActionButton icon={NearerIcon} action="depth_nearer" />
      <ActionButton icon={FartherIcon} action="depth_farther" />
      <Popover icon={AdjustIcon} label={studio.word("thickness_and_colour")}>
        <Thickness value={first.thickness} />
        <ColourSwatches
          colour={first.fill}
          onColour={(colour) => {
            studio.act("fill", colour ?? "none");
          }}
        />
      </Popover>
      <ActionButton icon={EditLinesIcon} action={first.isOpen ? "close_part" : "open_part"} />
      <ActionButton icon={DeleteIcon} action="delete" tone="danger" />
    </div>
  );
}
