// SPDX-License-Identifier: Apache-2.0
import { useRoving } from "./roving";
import "../styles/segmented.css";

export interface Segment<T extends string> {
  readonly value: T;
  readonly label: string;
  readonly chord?: string;
  readonly isEnabled?: boolean;
}

interface SegmentedProps<T extends string> {
  readonly label: string;
  readonly segments: readonly Segment<T>[];
  readonly chosen: T;
  readonly onChoose: (value: T) => void;
}

/** One of a few, all in sight; the ground of the chosen one slides to it. */
export function Segmented<T extends string>(props: SegmentedProps<T>) {
  const { segments, chosen, onChoose } = props;
  const roving = useRoving<HTMLDivElement>("both", (item) => {
    item.click();
  });
  const index = segments.findIndex((segment) => segment.value === chosen);
  return (
    <div
      {...roving}
      class="segmented"
      role="radiogroup"
      aria-label={props.label}
      style={{ "--count": segments.length, "--index": Math.max(index, 0) }}
    >
      <span class="segmented-thumb" aria-hidden="true" data-is-shown={index >= 0} />
      {segments.map(({ value, label, chord = "", isEnabled = true }) => (
        <button
          key={value}
          type="button"
          class="segment"
          role="radio"
          data-roving=""
          data-tip={chord === "" ? undefined : label}
          data-tip-chord={chord}
          aria-checked={value === chosen}
          aria-disabled={!isEnabled}
          onClick={() => {
            if (isEnabled && value !== chosen) onChoose(value);
          }}
        >
          {label}
        </button>
      ))}
    </div>
  );
}
