// SPDX-License-Identifier: Apache-2.0
import { Slider, type Scale } from "./slider";
import { useStudio } from "./studio-context";
import "../styles/auto-slider.css";

interface AutoSliderProps {
  readonly label: string;
  /** null: the core finds it by itself. */
  readonly value: number | null;
  /** Where the slider stands meanwhile, and what is taken when that ends. */
  readonly rest: number;
  readonly scale: Scale;
  readonly text: (value: number) => string;
  /** What it means that the core finds it. */
  readonly autoTip: string;
  readonly onChange: (value: number | null) => void;
}

/** A number as the person says, or as the core finds best. */
export function AutoSlider(props: AutoSliderProps) {
  const studio = useStudio();
  const { value, rest, onChange } = props;
  const isAuto = value === null;
  return (
    <div class="auto-slider" data-is-auto={isAuto}>
      <Slider
        label={props.label}
        value={value ?? rest}
        scale={props.scale}
        text={props.text}
        onInput={onChange}
      />
      <button
        type="button"
        class="toggle"
        aria-pressed={isAuto}
        data-tip={props.autoTip}
        onClick={() => {
          onChange(isAuto ? rest : null);
        }}
      >
        {studio.word("auto")}
      </button>
    </div>
  );
}
