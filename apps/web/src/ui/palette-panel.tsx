// SPDX-License-Identifier: Apache-2.0
import type { TargetedKeyboardEvent } from "preact";
import { useId, useLayoutEffect, useRef, useState } from "preact/hooks";
import "../styles/palette-panel.css";
import { choiceLabel } from "./choice-words";
import { KeyCap } from "./key-cap";
import { findEntries, paletteEntries, type PaletteEntry } from "./palette-search";
import { Panel } from "./panel";
import { useStudio } from "./studio-context";

interface PaletteArgumentProps {
  readonly entry: PaletteEntry;
  readonly onDone: (argument: string) => void;
  readonly onBack: () => void;
}

/** Asks for what the action is to be done with, where its name was typed. */
function PaletteArgument({ entry, onDone, onBack }: PaletteArgumentProps) {
  const field = useRef<HTMLInputElement>(null);
  useLayoutEffect(() => {
    field.current?.focus();
  }, []);
  return (
    <label class="palette-argument">
      <span>{entry.labels[0]}</span>
      <input
        ref={field}
        type="text"
        inputMode={entry.asksFor === "number" ? "decimal" : "text"}
        autocomplete="off"
        onKeyDown={(event) => {
          const typed = event.currentTarget.value.trim();
          if (event.key === "Enter" && typed !== "") {
            onDone(entry.asksFor === "number" ? typed.replace(",", ".") : typed);
          } else if (event.key === "Escape") {
            event.stopPropagation();
            onBack();
          }
        }}
      />
    </label>
  );
}

interface PaletteListProps {
  readonly id: string;
  readonly found: readonly PaletteEntry[];
  readonly active: number;
  readonly onActive: (index: number) => void;
  readonly onChosen: (entry: PaletteEntry) => void;
}

function PaletteList({ id, found, active, onActive, onChosen }: PaletteListProps) {
  const studio = useStudio();
  const list = useRef<HTMLUListElement>(null);
  useLayoutEffect(() => {
    list.current?.children[active]?.scrollIntoView({ block: "nearest" });
  }, [active]);
  return (
    <ul ref={list} id={id} class="palette-list" role="listbox" aria-label={studio.word("actions")}>
      {found.map((entry, index) => (
        <li
          key={entry.id}
          id={`${id}-${index}`}
          class="palette-entry"
          role="option"
          aria-selected={index === active}
          aria-disabled={!studio.isEnabled(entry.action)}
          onPointerMove={() => {
            onActive(index);
          }}
          onClick={() => {
            onChosen(entry);
          }}
        >
          <span class="palette-label">{entry.labels[0]}</span>
          {entry.choice === null && <KeyCap action={entry.action} />}
        </li>
      ))}
    </ul>
  );
}

/** Finds an action by any of its words, in either language, and does it. */
export function PalettePanel() {
  const studio = useStudio();
  const listId = useId();
  const [query, setQuery] = useState("");
  const [active, setActive] = useState(0);
  const [asked, setAsked] = useState<PaletteEntry | null>(null);
  const language = studio.preferences.language.value;
  const entries = paletteEntries(studio.actions.value, language, choiceLabel);
  const find = (typed: string) => findEntries(entries, typed, (action) => studio.isEnabled(action));
  const found = find(query);
  const activeEntry = found[active];

  const close = () => {
    studio.panel.value = null;
  };
  const run = (entry: PaletteEntry, argument: string) => {
    // First, so that an action that opens another panel can.
    close();
    studio.act(entry.action, argument);
  };
  const choose = (entry: PaletteEntry) => {
    if (!studio.isEnabled(entry.action)) return;
    if (entry.asksFor === null) run(entry, entry.choice ?? "");
    else setAsked(entry);
  };
  const onKeyDown = (event: TargetedKeyboardEvent<HTMLInputElement>) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step !== undefined && found.length > 0) {
      setActive((active + step + found.length) % found.length);
      event.preventDefault();
    }
    if (event.key !== "Enter") return;
    // Enter may come before what was typed last has been shown: it means what stands in the field.
    const typed = event.currentTarget.value;
    const meant = typed === query ? activeEntry : find(typed)[0];
    if (meant !== undefined) choose(meant);
  };

  const field = (
    <input
      class="palette-field"
      type="text"
      role="combobox"
      data-first-focus
      aria-expanded={found.length > 0}
      aria-controls={listId}
      aria-autocomplete="list"
      aria-activedescendant={activeEntry === undefined ? undefined : `${listId}-${active}`}
      aria-label={studio.label("palette")}
      placeholder={studio.word("palette_ask")}
      autocomplete="off"
      spellcheck={false}
      value={query}
      onInput={(event) => {
        setQuery(event.currentTarget.value);
        setActive(0);
      }}
      onKeyDown={onKeyDown}
    />
  );
  return (
    <Panel
      title={studio.label("palette")}
      place="top"
      onClose={close}
      head={asked === null && field}
    >
      {asked === null ? (
        <>
          <PaletteList id={listId} {...{ found, active }} onActive={setActive} onChosen={choose} />
          <p class="palette-none" role="status">
            {found.length === 0 && studio.word("nothing_found")}
          </p>
        </>
      ) : (
        <PaletteArgument
          entry={asked}
          onBack={() => {
            setAsked(null);
          }}
          onDone={(argument) => {
            run(asked, argument);
          }}
        />
      )}
    </Panel>
  );
}
