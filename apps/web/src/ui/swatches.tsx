// SPDX-License-Identifier: Apache-2.0
import { useMemo, useRef } from "preact/hooks";
import type { Word } from "../studio/words";
import { eachFrame } from "./each-frame";
import { CheckIcon, OtherColourIcon } from "./icons";
import { useRoving } from "./roving";
import { useStudio } from "./studio-context";
import "../styles/swatches.css";

export interface Swatch {
  readonly colour: string;
  readonly name: Word;
}

interface SwatchesProps {
  readonly label: string;
  readonly swatches: readonly Swatch[];
  /** "#rrggbb"; null: none is chosen. */
  readonly chosen: string | null;
  readonly onChoose: (colour: string) => void;
}

function isLight(colour: string): boolean {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) =>
    parseInt(colour.slice(at, at + 2), 16),
  );
  return 0.3 * red + 0.59 * green + 0.11 * blue > 150;
}

function SwatchButton(props: {
  readonly swatch: Swatch;
  readonly isChosen: boolean;
  readonly onChoose: () => void;
}) {
  const studio = useStudio();
  const { swatch, isChosen } = props;
  const name = studio.word(swatch.name);
  return (
    <button
      type="button"
      class="swatch"
      role="radio"
      data-roving=""
      data-tip={name}
      data-is-light={isLight(swatch.colour)}
      aria-label={name}
      aria-checked={isChosen}
      style={{ "--swatch": swatch.colour }}
      onClick={props.onChoose}
    >
      {isChosen && <CheckIcon aria-hidden="true" />}
    </button>
  );
}

/** The browser's own picker for every other colour. */
function OtherColour({
  chosen,
  isOther,
  onChoose,
}: {
  readonly chosen: string | null;
  readonly isOther: boolean;
  readonly onChoose: (colour: string) => void;
}) {
  const studio = useStudio();
  const take = useRef(onChoose);
  take.current = onChoose;
  const values = useMemo(
    () =>
      eachFrame<string>((colour) => {
        take.current(colour);
      }),
    [],
  );
  const colour = chosen ?? "#22242b";
  return (
    <label
      class="swatch swatch-other"
      data-tip={studio.word("other_colour")}
      data-is-chosen={isOther}
      data-is-light={!isOther || isLight(colour)}
      style={{ "--swatch": isOther ? colour : "transparent" }}
    >
      <OtherColourIcon aria-hidden="true" />
      <input
        type="color"
        value={colour}
        aria-label={studio.word("other_colour")}
        onInput={(event) => {
          values.put(event.currentTarget.value);
        }}
        onChange={values.flush}
      />
    </label>
  );
}

/** A few colours, and any other. */
export function Swatches({ label, swatches, chosen, onChoose }: SwatchesProps) {
  const roving = useRoving<HTMLDivElement>("both", (item) => {
    item.click();
  });
  const isOther = chosen !== null && swatches.every((swatch) => swatch.colour !== chosen);
  return (
    <div class="swatches">
      <div {...roving} class="swatch-row" role="radiogroup" aria-label={label}>
        {swatches.map((swatch) => (
          <SwatchButton
            key={swatch.colour}
            swatch={swatch}
            isChosen={swatch.colour === chosen}
            onChoose={() => {
              onChoose(swatch.colour);
            }}
          />
        ))}
      </div>
      <OtherColour chosen={chosen} isOther={isOther} onChoose={onChoose} />
    </div>
  );
}
