// SPDX-License-Identifier: Apache-2.0
import { useMemo, useRef } from "preact/hooks";
import type { Word } from "../studio/words";
import { eachFrame } from "./each-frame";
import { CheckIcon, OtherColourIcon } from "./icons";
import { useRoving } from "./roving";
import { useStudio } from "./studio-context";
import "../styles/inks.css";

interface Ink {
  readonly colour: string;
  readonly name: Word;
}

/** What a drawing needs: a black, and five that stay apart from each other when the model turns. */
const inks: readonly Ink[] = [
  { colour: "#22242b", name: "ink_black" },
  { colour: "#7b4a2e", name: "ink_brown" },
  { colour: "#c8372d", name: "ink_red" },
  { colour: "#e0a12b", name: "ink_yellow" },
  { colour: "#4b8b43", name: "ink_green" },
  { colour: "#2f5fb3", name: "ink_blue" },
];

function isLight(colour: string): boolean {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) =>
    parseInt(colour.slice(at, at + 2), 16),
  );
  return 0.3 * red + 0.59 * green + 0.11 * blue > 150;
}

function InkSwatch(props: {
  readonly ink: Ink;
  readonly isChosen: boolean;
  readonly onChoose: () => void;
}) {
  const studio = useStudio();
  const { ink, isChosen } = props;
  const name = studio.word(ink.name);
  return (
    <button
      type="button"
      class="ink-swatch"
      role="radio"
      data-roving=""
      data-tip={name}
      data-is-light={isLight(ink.colour)}
      aria-label={name}
      aria-checked={isChosen}
      style={{ "--swatch": ink.colour }}
      onClick={props.onChoose}
    >
      {isChosen && <CheckIcon aria-hidden="true" />}
    </button>
  );
}

/** The browser's own picker for every other colour. */
function OtherInk(props: {
  readonly colour: string;
  readonly isChosen: boolean;
  readonly onChoose: (colour: string) => void;
}) {
  const studio = useStudio();
  const { colour, isChosen } = props;
  const take = useRef(props.onChoose);
  take.current = props.onChoose;
  const values = useMemo(
    () =>
      eachFrame<string>((next) => {
        take.current(next);
      }),
    [],
  );
  const name = studio.word("other_colour");
  return (
    <label
      class="ink-swatch ink-other"
      data-tip={name}
      data-is-chosen={isChosen}
      data-is-light={!isChosen || isLight(colour)}
      style={{ "--swatch": isChosen ? colour : "transparent" }}
    >
      <OtherColourIcon aria-hidden="true" />
      <input
        type="color"
        value={colour}
        aria-label={name}
        onInput={(event) => {
          values.put(event.currentTarget.value);
        }}
        onChange={values.flush}
      />
    </label>
  );
}

/** A few inks, and any other. */
export function Inks() {
  const studio = useStudio();
  const roving = useRoving<HTMLDivElement>("both", (item) => {
    item.click();
  });
  const chosen = studio.state.value.ink;
  const choose = (colour: string) => {
    studio.act("ink_colour", colour);
  };
  return (
    <div class="inks">
      <div {...roving} class="ink-row" role="radiogroup" aria-label={studio.label("ink_colour")}>
        {inks.map((ink) => (
          <InkSwatch
            key={ink.colour}
            ink={ink}
            isChosen={ink.colour === chosen}
            onChoose={() => {
              choose(ink.colour);
            }}
          />
        ))}
      </div>
      <OtherInk
        colour={chosen}
        isChosen={inks.every((ink) => ink.colour !== chosen)}
        onChoose={choose}
      />
    </div>
  );
}
