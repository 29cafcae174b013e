// SPDX-License-Identifier: Apache-2.0
import { ActionButton } from "./icon-button";
import { FitIcon, MinusIcon, PlusIcon } from "./icons";
import { useStudio } from "./studio-context";

/** How the paper is held. */
export function HandSettings() {
  const studio = useStudio();
  return (
    <div class="context-icons">
      <ActionButton icon={MinusIcon} action="zoom_out" />
      <button
        type="button"
        class="zoom-value"
        data-tip={studio.label("zoom_actual")}
        data-tip-chord={studio.chord("zoom_actual")}
        onClick={() => {
          studio.act("zoom_actual");
        }}
      >
        {studio.word("percent", Math.round(100 * studio.state.value.zoom))}
      </button>
      <ActionButton icon={PlusIcon} action="zoom_in" />
      <ActionButton icon={FitIcon} action="zoom_fit" />
    </div>
  );
}
