// SPDX-License-Identifier: Apache-2.0
import { useId } from "preact/hooks";
import "../styles/switch-row.css";

interface SwitchRowProps {
  readonly label: string;
  readonly note?: string;
  readonly isOn: boolean;
  readonly onSwitch: (isOn: boolean) => void;
}

/** Something that is on or off. */
export function SwitchRow({ label, note, isOn, onSwitch }: SwitchRowProps) {
  const noteId = useId();
  return (
    <div class="setting">
      <label class="switch-row">
        <span>{label}</span>
        <input
          type="checkbox"
          role="switch"
          checked={isOn}
          aria-describedby={note === undefined ? undefined : noteId}
          onChange={(event) => {
            onSwitch(event.currentTarget.checked);
          }}
        />
      </label>
      {note !== undefined && (
        <p id={noteId} class="setting-note">
          {note}
        </p>
      )}
    </div>
  );
}
