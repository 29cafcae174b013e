// SPDX-License-Identifier: Apache-2.0
import type { Signal } from "@preact/signals";
import type { Word } from "../studio/words";
import "../styles/settings-panel.css";
import { Panel } from "./panel";
import { Segmented } from "./segmented";
import { useStudio } from "./studio-context";
import { SwitchRow } from "./switch-row";
import { useStorageEstimate } from "./use-storage-estimate";

interface ChoiceRowProps<T extends string> {
  readonly label: string;
  readonly setting: Signal<T>;
  readonly choices: readonly (readonly [T, Word])[];
}

function ChoiceRow<T extends string>({ label, setting, choices }: ChoiceRowProps<T>) {
  const studio = useStudio();
  return (
    <div class="setting">
      <p class="setting-label" aria-hidden="true">
        {label}
      </p>
      <Segmented
        label={label}
        segments={choices.map(([value, text]) => ({ value, label: studio.word(text) }))}
        chosen={setting.value}
        onChoose={(value) => {
          setting.value = value;
        }}
      />
    </div>
  );
}

function Storage() {
  const studio = useStudio();
  const facts = useStorageEstimate();
  const saveState = studio.saveState.value;
  const refusal = { full: "not_saved_full", unavailable: "not_saved_unavailable" } as const;
  const text = saveState.kind === "refused" ? refusal[saveState.why] : saveState.kind;
  const language = studio.preferences.language.value;
  const megabytes = ((facts?.usedBytes ?? 0) / 1e6).toLocaleString(language, {
    maximumSignificantDigits: 2,
  });
  return (
    <section class="setting">
      <h3 class="setting-heading">{studio.word("storage")}</h3>
      <p>{studio.word(text)}</p>
      {facts !== null && (
        <p class="setting-note">
          {studio.word("storage_used", megabytes)}{" "}
          {!facts.isPersistent && studio.word("storage_may_go")}
        </p>
      )}
    </section>
  );
}

/** How a person likes the studio; nothing of it is in the drawing. */
export function SettingsPanel() {
  const studio = useStudio();
  const { theme, paper, language, singleKeys, hints, bendHint } = studio.preferences;
  const close = () => {
    studio.panel.value = null;
  };
  return (
    <Panel title={studio.word("settings")} onClose={close}>
      <ChoiceRow
        label={studio.word("theme")}
        setting={theme}
        choices={[
          ["system", "theme_system"],
          ["light", "theme_light"],
          ["dark", "theme_dark"],
        ]}
      />
      <ChoiceRow
        label={studio.word("paper_in_dark")}
        setting={paper}
        choices={[
          ["light", "paper_light"],
          ["slate", "paper_slate"],
        ]}
      />
      <ChoiceRow
        label={studio.label("language")}
        setting={language}
        choices={[
          ["en", "language_english"],
          ["cs", "language_czech"],
        ]}
      />
      <SwitchRow
        label={studio.label("grid")}
        isOn={studio.state.value.hasGrid}
        onSwitch={() => {
          studio.act("grid");
        }}
      />
      <SwitchRow
        label={studio.label("single_keys")}
        note={studio.word("single_keys_note")}
        isOn={singleKeys.value === "on"}
        onSwitch={(isOn) => {
          singleKeys.value = isOn ? "on" : "off";
        }}
      />
      <SwitchRow
        label={studio.word("hints")}
        note={studio.word("hints_note")}
        isOn={hints.value === "show"}
        onSwitch={(isOn) => {
          hints.value = bendHint.value = isOn ? "show" : "done";
        }}
      />
      <Storage />
    </Panel>
  );
}
