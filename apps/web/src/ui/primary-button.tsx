// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "../protocol/actions.generated";
import { useStudio } from "./studio-context";
import "../styles/buttons.css";

/** What one most likely wants to do next: the only filled button of the page. */
export function PrimaryButton({ action }: { readonly action: ActionName }) {
  const studio = useStudio();
  const isEnabled = studio.isEnabled(action);
  return (
    <button
      type="button"
      class="primary-button"
      aria-disabled={!isEnabled}
      onClick={() => {
        if (isEnabled) studio.act(action);
      }}
    >
      {studio.label(action)}
      <kbd aria-hidden="true">{studio.chord(action)}</kbd>
    </button>
  );
}
