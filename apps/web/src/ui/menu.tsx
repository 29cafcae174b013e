// SPDX-License-Identifier: Apache-2.0
import { useRef } from "preact/hooks";
import type { ActionName } from "../protocol/actions.generated";
import type { Language } from "../protocol/state";
import type { Panel, Studio } from "../studio/studio";
import {
  AddPictureIcon,
  CheckIcon,
  ExamplesIcon,
  ExportIcon,
  HelpIcon,
  NewIcon,
  OpenIcon,
  PaletteIcon,
  RemovePictureIcon,
  SaveIcon,
  SessionsIcon,
  SettingsIcon,
  type Icon,
} from "./icons";
import { useRoving } from "./roving";
import { SaveMark } from "./save-mark";
import { useStudio } from "./studio-context";
import { useBorrowedFocus, useDismissal } from "./use-dismissal";
import "../styles/menu.css";

interface MenuRow {
  readonly icon: Icon;
  readonly label: string;
  readonly chord?: string;
  readonly isEnabled?: boolean;
  readonly run: () => void;
}

function actionRow(studio: Studio, action: ActionName, icon: Icon): MenuRow {
  return {
    icon,
    label: studio.label(action),
    chord: studio.chord(action),
    isEnabled: studio.isEnabled(action),
    run: () => {
      studio.act(action);
    },
  };
}

function panelRow(studio: Studio, panel: Panel, icon: Icon, label: string): MenuRow {
  return {
    icon,
    label,
    run: () => {
      studio.panel.value = panel;
    },
  };
}

/** The rows between the lines. */
function rowsOf(studio: Studio): readonly (readonly MenuRow[])[] {
  const { hasTemplate } = studio.state.value;
  return [
    [
      actionRow(studio, "new", NewIcon),
      actionRow(studio, "open", OpenIcon),
      actionRow(studio, "save", SaveIcon),
      actionRow(studio, "export", ExportIcon),
    ],
    [
      hasTemplate
        ? actionRow(studio, "remove_template", RemovePictureIcon)
        : actionRow(studio, "open_template", AddPictureIcon),
    ],
    [
      panelRow(studio, "gallery", ExamplesIcon, studio.word("examples")),
      panelRow(studio, "sessions", SessionsIcon, studio.word("earlier_drawings")),
    ],
    [
      actionRow(studio, "palette", PaletteIcon),
      panelRow(studio, "settings", SettingsIcon, studio.word("settings")),
      actionRow(studio, "help", HelpIcon),
    ],
  ];
}

function MenuItem({ row, isFirst }: { readonly row: MenuRow; readonly isFirst: boolean }) {
  const studio = useStudio();
  const { icon: Picture, label, chord = "", isEnabled = true } = row;
  return (
    <button
      type="button"
      class="menu-item"
      role="menuitem"
      data-roving=""
      data-first-focus={isFirst ? "" : undefined}
      aria-disabled={!isEnabled}
      onClick={() => {
        if (!isEnabled) return;
        studio.panel.value = null;
        row.run();
      }}
    >
      <Picture aria-hidden="true" />
      <span>{label}</span>
      <kbd>{chord}</kbd>
    </button>
  );
}

/** Each in its own language, so that whoever got the wrong one finds the way out. */
const languages: readonly { readonly language: Language; readonly name: string }[] = [
  { language: "en", name: "English" },
  { language: "cs", name: "Čeština" },
];

function LanguageItems() {
  const studio = useStudio();
  const chosen = studio.preferences.language;
  return (
    <div class="menu-group" role="group" aria-label={studio.label("language")}>
      {languages.map(({ language, name }) => (
        <button
          key={language}
          type="button"
          class="menu-item"
          role="menuitemradio"
          lang={language}
          data-roving=""
          aria-checked={chosen.value === language}
          onClick={() => {
            chosen.value = language;
          }}
        >
          <CheckIcon aria-hidden="true" />
          <span>{name}</span>
        </button>
      ))}
    </div>
  );
}

/** Everything about the drawing as a whole. */
export function Menu() {
  const studio = useStudio();
  const roving = useRoving<HTMLDivElement>("vertical");
  const frame = useRef<HTMLElement>(null);
  useDismissal(frame, () => {
    studio.panel.value = null;
  });
  useBorrowedFocus(frame);
  return (
    <nav class="menu surface-raised" ref={frame} aria-label={studio.word("menu")}>
      <SaveMark />
      <div {...roving} role="menu" aria-label={studio.word("menu")}>
        {rowsOf(studio).map((rows, index) => (
          <div key={index} class="menu-group" role="group">
            {rows.map((row, place) => (
              <MenuItem key={row.label} row={row} isFirst={index + place === 0} />
            ))}
          </div>
        ))}
        <LanguageItems />
      </div>
    </nav>
  );
}
