// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "../protocol/actions.generated";
import type { Icon } from "./icons";
import { useStudio } from "./studio-context";
import "../styles/buttons.css";

interface IconButtonProps {
  readonly icon: Icon;
  /** The button's name: read out, and shown by its tooltip. */
  readonly label: string;
  readonly chord?: string;
  readonly isPressed?: boolean;
  readonly isExpanded?: boolean;
  readonly isEnabled?: boolean;
  /** Reached by the arrows of the row it stands in. */
  readonly isRoving?: boolean;
  readonly tone?: "plain" | "danger";
  readonly onClick: () => void;
}

/** A button that is an icon. One that can do nothing now keeps its place, its name and the focus. */
export function IconButton(props: IconButtonProps) {
  const { icon: Picture, label, chord = "", isEnabled = true, tone = "plain" } = props;
  return (
    <button
      type="button"
      class="icon-button"
      data-tone={tone}
      data-tip={label}
      data-tip-chord={chord}
      data-roving={props.isRoving === true ? "" : undefined}
      aria-label={label}
      aria-pressed={props.isPressed}
      aria-expanded={props.isExpanded}
      aria-disabled={!isEnabled}
      onClick={() => {
        if (isEnabled) props.onClick();
      }}
    >
      <Picture aria-hidden="true" />
    </button>
  );
}

interface ActionButtonProps {
  readonly icon: Icon;
  readonly action: ActionName;
  /** What else to say of it than the action's name. */
  readonly label?: string;
  readonly tone?: "plain" | "danger";
  readonly isRoving?: boolean;
}

/** An icon for an action of the core's table. */
export function ActionButton({ icon, action, label, tone, isRoving }: ActionButtonProps) {
  const studio = useStudio();
  return (
    <IconButton
      icon={icon}
      label={label ?? studio.label(action)}
      chord={studio.chord(action)}
      isEnabled={studio.isEnabled(action)}
      tone={tone ?? "plain"}
      isRoving={isRoving ?? false}
      onClick={() => {
        studio.act(action);
      }}
    />
  );
}
