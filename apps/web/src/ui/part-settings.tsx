// SPDX-License-Identifier: Apache-2.0
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
import { isNarrow } from "./narrow";
import { Popover } from "./popover";
import { ratioScale } from "./scales";
import { Slider } from "./slider";
import { useStudio } from "./studio-context";
import { Swatches, type Swatch } from "./swatches";

/** Skins and clothes of simple characters. */
const fills: readonly Swatch[] = [
  { colour: "#f3d9b8", name: "fill_sand" },
  { colour: "#e98b73", name: "fill_coral" },
  { colour: "#f2c14e", name: "fill_yellow" },
  { colour: "#8dbb78", name: "fill_green" },
  { colour: "#7fb0d6", name: "fill_blue" },
  { colour: "#b79ad1", name: "fill_violet" },
];

/** 1 is as the drawing suggests; the core takes 0.1 to 32. */
const thicknessScale = ratioScale(0.1, 10);

export function Thickness({ value }: { readonly value: number }) {
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

export function Fill({ colour }: { readonly colour: string | null }) {
  const studio = useStudio();
  return (
    <Swatches
      label={studio.label("fill")}
      swatches={fills}
      chosen={colour}
      onChoose={(next) => {
        studio.act("fill", next);
      }}
    />
  );
}

/** What can be done to the parts that are selected. Their looks and lines are beside the stack of parts where it has a place. */
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
      {isNarrow.value && (
        <>
          <Popover icon={AdjustIcon} label={studio.word("thickness_and_colour")}>
            <Thickness value={first.thickness} />
            <Fill colour={first.fill} />
          </Popover>
          <ActionButton icon={EditLinesIcon} action={first.isOpen ? "close_part" : "open_part"} />
        </>
      )}
      <ActionButton icon={DeleteIcon} action="delete" tone="danger" />
    </div>
  );
}
