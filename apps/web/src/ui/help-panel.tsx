// SPDX-License-Identifier: Apache-2.0
import { Copy, Eraser, Hand, MousePointerClick, Spline, Undo2 } from "lucide-preact";
import { useState } from "preact/hooks";
import { version } from "../../package.json";
import type { Menu } from "../protocol/state";
import type { Word } from "../studio/words";
import "../styles/help-panel.css";
import { AddPinIcon, BendIcon, type Icon } from "./icons";
import { KeyCap } from "./key-cap";
import { keyGroups } from "./key-groups";
import { Panel } from "./panel";
import { SearchField } from "./search-field";
import { useStudio } from "./studio-context";

const tips: readonly (readonly [Icon, Word])[] = [
  [Hand, "tip_two_fingers"],
  [Undo2, "tip_tap_undo"],
  [Eraser, "tip_pen_eraser"],
  [Copy, "tip_double_click"],
  [Spline, "tip_help_line"],
  [BendIcon, "tip_bend"],
  [AddPinIcon, "tip_pin"],
  [MousePointerClick, "tip_right_button"],
];

const menuWords: Readonly<Record<Menu, Word>> = {
  file: "menu_file",
  edit: "menu_edit",
  view: "menu_view",
  tool: "menu_tool",
  part: "menu_part",
  model: "menu_model",
  help: "menu_help",
};

function Tips() {
  const studio = useStudio();
  return (
    <section class="help-section">
      <h3>{studio.word("help_tips")}</h3>
      <ul class="help-tips">
        {tips.map(([Icon, text]) => (
          <li key={text}>
            <Icon size={18} aria-hidden="true" />
            <span>{studio.word(text)}</span>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Keys({ query }: { readonly query: string }) {
  const studio = useStudio();
  const groups = keyGroups(studio.actions.value, query, studio.preferences.language.value);
  return (
    <section class="help-section">
      <h3>{studio.word("help_keys")}</h3>
      {groups.length === 0 && <p class="help-none">{studio.word("nothing_found")}</p>}
      {groups.map(({ menu, rows }) => (
        <section key={menu} class="help-group">
          <h4>{studio.word(menuWords[menu])}</h4>
          <dl>
            {rows.map((row) => (
              <div key={row.name} class="help-key">
                <dt>{studio.label(row.name)}</dt>
                <dd>
                  <KeyCap action={row.name} />
                </dd>
              </div>
            ))}
          </dl>
        </section>
      ))}
    </section>
  );
}

function About() {
  const studio = useStudio();
  return (
    <section class="help-section help-about">
      <h3>
        {studio.word("app_name")} {version}
      </h3>
      <p>{studio.word("about_private")}</p>
      <p>{studio.word("about_licence")}</p>
    </section>
  );
}

/** What is worth knowing, all keys, and what this is. */
export function HelpPanel() {
  const studio = useStudio();
  const [query, setQuery] = useState("");
  const close = () => {
    studio.panel.value = null;
  };
  const field = <SearchField label={studio.word("find_key")} value={query} onValue={setQuery} />;
  return (
    <Panel title={studio.label("help")} onClose={close} head={field} isReading>
      {query === "" && <Tips />}
      <Keys query={query} />
      {query === "" && <About />}
    </Panel>
  );
}
