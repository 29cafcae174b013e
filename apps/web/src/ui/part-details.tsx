// SPDX-License-Identifier: Apache-2.0
import { ArrowDown, ArrowUp, Copy, Pencil, TextCursorInput, Trash } from "lucide-preact";
import { useId } from "preact/hooks";
import type { ActionName } from "../protocol/actions.generated";
import type { LayerRow } from "../protocol/state";
import { ColourSwatches } from "./colour-swatches";
import { partName } from "./part-name";
import { useStudio } from "./studio-context";
import { stepOf, thicknessAt, thicknessSteps } from "./thickness-scale";

interface PartDetailsProps {
  /** At least one. */
  readonly selected: readonly LayerRow[];
  readonly onRename: (id: number) => void;
}

/** What all of them have; undefined: they differ. */
function common<T>(values: readonly T[]): T | undefined {
  return values.every((value) => value === values[0]) ? values[0] : undefined;
}

function Thickness({ selected }: Pick<PartDetailsProps, "selected">) {
  const studio = useStudio();
  const id = useId();
  const thickness = common(selected.map((part) => part.thickness));
  const shown = thickness ?? selected[0]?.thickness ?? 1;
  const text = thickness === undefined ? studio.word("values_differ") : formatted(thickness);
  return (
    <div class="part-thickness">
      <label for={id}>{studio.label("thickness")}</label>
      <input
        id={id}
        type="range"
        min={0}
        max={thicknessSteps}
        value={stepOf(shown)}
        aria-valuetext={text}
        onInput={(event) => {
          studio.act("thickness", String(thicknessAt(event.currentTarget.valueAsNumber)));
        }}
      />
      <output for={id}>{text}</output>
    </div>
  );

  function formatted(value: number): string {
    return value.toLocaleString(studio.preferences.language.value, { maximumSignificantDigits: 2 });
  }
}

function ActionIcon({
  name,
  icon: Icon,
}: {
  readonly name: ActionName;
  readonly icon: typeof Copy;
}) {
  const studio = useStudio();
  const label = studio.label(name);
  const chord = studio.chord(name);
  return (
    <button
      type="button"
      class="part-action"
      aria-label={label}
      title={chord === "" ? label : `${label} (${chord})`}
      disabled={!studio.isEnabled(name)}
      onClick={() => {
        studio.act(name);
      }}
    >
      <Icon size={16} aria-hidden="true" />
    </button>
  );
}

/** Everything about the parts that are selected. */
export function PartDetails({ selected, onRename }: PartDetailsProps) {
  const studio = useStudio();
  const [first] = selected;
  if (first === undefined) return null;
  const name =
    selected.length === 1
      ? partName(studio, first)
      : studio.word("parts_selected", selected.length);
  const lines: ActionName = selected.some((part) => part.isOpen) ? "close_part" : "open_part";
  return (
    <section class="part-details" aria-label={studio.word("part_details", name)}>
      <Thickness selected={selected} />
      <ColourSwatches
        colour={common(selected.map((part) => part.fill))}
        onColour={(colour) => {
          studio.act("fill", colour ?? "none");
        }}
      />
      <div class="part-actions">
        <ActionIcon name="depth_nearer" icon={ArrowUp} />
        <ActionIcon name="depth_farther" icon={ArrowDown} />
        {selected.length === 1 && (
          <button
            type="button"
            class="part-action"
            aria-label={studio.label("rename_part")}
            title={`${studio.label("rename_part")} (F2)`}
            onClick={() => {
              onRename(first.id);
            }}
          >
            <TextCursorInput size={16} aria-hidden="true" />
          </button>
        )}
        <ActionIcon name="duplicate" icon={Copy} />
        <ActionIcon name="delete" icon={Trash} />
      </div>
      <div class="part-lines">
        <button
          type="button"
          class="part-button"
          onClick={() => {
            studio.act(lines);
          }}
        >
          <Pencil size={15} aria-hidden="true" />
          {studio.word(lines === "open_part" ? "edit_lines" : "stop_editing")}
        </button>
        <button
          type="button"
          class="part-button"
          onClick={() => {
            studio.act("redraw_part");
          }}
        >
          {studio.word("redraw")}
        </button>
      </div>
    </section>
  );
}
