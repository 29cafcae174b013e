// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "../protocol/actions.generated";
import type { Mode } from "../protocol/state";
import { Segmented } from "./segmented";
import { useStudio } from "./studio-context";

const modes: readonly { readonly mode: Mode; readonly action: ActionName }[] = [
  { mode: "draw", action: "mode_draw" },
  { mode: "inflate", action: "mode_inflate" },
];

export function ModeSwitch() {
  const studio = useStudio();
  const { mode } = studio.state.value;
  return (
    <div class="mode-switch surface">
      <Segmented
        label={studio.word("modes")}
        chosen={mode}
        segments={modes.map(({ mode: value, action }) => ({
          value,
          label: studio.label(action),
          chord: studio.chord(action),
          isEnabled: studio.isEnabled(action),
        }))}
        onChoose={(value) => {
          studio.act(`mode_${value}`);
        }}
      />
    </div>
  );
}
