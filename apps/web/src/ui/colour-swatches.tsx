// SPDX-License-Identifier: Apache-2.0
import { Ban, Check, Pipette } from "lucide-preact";
import type { Word } from "../studio/words";
import { useStudio } from "./studio-context";

/** Clay in a few colours that go together on the paper. */
const colours: readonly (readonly [string, Word])[] = [
  ["#ffffff", "colour_white"],
  ["#f2cf63", "colour_yellow"],
  ["#f2a65a", "colour_orange"],
  ["#e8604c", "colour_red"],
  ["#e59ab0", "colour_pink"],
  ["#8d7bc7", "colour_violet"],
  ["#6fa8dc", "colour_blue"],
  ["#3fa796", "colour_teal"],
  ["#8dbb6a", "colour_green"],
  ["#a9805f", "colour_brown"],
  ["#4a4d57", "colour_grey"],
];

interface ColourSwatchesProps {
  /** null: as the look has it; undefined: several. */
  readonly colour: string | null | undefined;
  readonly onColour: (colour: string | null) => void;
}

/** Colours to tap, none of them, and any other. */
export function ColourSwatches({ colour, onColour }: ColourSwatchesProps) {
  const studio = useStudio();
  const isOwn = typeof colour === "string" && !colours.some(([value]) => value === colour);
  const other = studio.word("colour_other");
  return (
    <div class="swatches" role="group" aria-label={studio.label("fill")}>
      <button
        type="button"
        class="swatch swatch-none"
        aria-pressed={colour === null}
        aria-label={studio.word("colour_none")}
        title={studio.word("colour_none")}
        onClick={() => {
          onColour(null);
        }}
      >
        <Ban size={14} aria-hidden="true" />
      </button>
      {colours.map(([value, name]) => (
        <button
          key={value}
          type="button"
          class="swatch"
          aria-pressed={value === colour}
          aria-label={studio.word(name)}
          title={studio.word(name)}
          style={{ "--swatch": value }}
          onClick={() => {
            onColour(value);
          }}
        >
          {value === colour && <Check size={14} aria-hidden="true" />}
        </button>
      ))}
      <label class="swatch swatch-other" data-own={isOwn} title={other}>
        <Pipette size={14} aria-hidden="true" />
        <input
          type="color"
          aria-label={other}
          value={colour ?? "#c9a48b"}
          onInput={(event) => {
            onColour(event.currentTarget.value);
          }}
        />
      </label>
    </div>
  );
}
