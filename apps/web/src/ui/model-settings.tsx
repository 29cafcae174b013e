// SPDX-License-Identifier: Apache-2.0
import type { Shading } from "../protocol/state";
import type { Word } from "../studio/words";
import { ActionButton } from "./icon-button";
import { FrontIcon, TurnDownIcon, TurnLeftIcon, TurnRightIcon, TurnUpIcon } from "./icons";
import { Segmented } from "./segmented";
import { useStudio } from "./studio-context";

const looks: readonly { readonly look: Shading; readonly name: Word }[] = [
  { look: "matcap", name: "look_clay" },
  { look: "textured", name: "look_drawing" },
  { look: "lines", name: "look_lines" },
];

/** How the model looks, and from where. Turning by buttons is for hands that cannot drag. */
export function ModelSettings() {
  const studio = useStudio();
  return (
    <>
      <Segmented
        label={studio.label("look")}
        chosen={studio.state.value.shading}
        segments={looks.map(({ look, name }) => ({ value: look, label: studio.word(name) }))}
        onChoose={(look) => {
          studio.act("look", look);
        }}
      />
      <div class="context-icons">
        <ActionButton icon={TurnLeftIcon} action="turn_left" />
        <ActionButton icon={TurnUpIcon} action="turn_up" />
        <ActionButton icon={TurnDownIcon} action="turn_down" />
        <ActionButton icon={TurnRightIcon} action="turn_right" />
        <ActionButton icon={FrontIcon} action="reset_turn" />
      </div>
      <button
        type="button"
        class="plain-button"
        data-tip={studio.label("mode_draw")}
        data-tip-chord={studio.chord("mode_draw")}
        onClick={() => {
          studio.act("mode_draw");
        }}
      >
        {studio.word("back_to_drawing")}
      </button>
    </>
  );
}
