// SPDX-License-Identifier: Apache-2.0
import { useEffect, useId, useMemo, useRef, useState } from "preact/hooks";
import { eachFrame } from "./each-frame";
import "../styles/slider.css";

/** Positions of the slider and what they mean. */
export interface Scale {
  readonly toPosition: (value: number) => number;
  readonly toValue: (position: number) => number;
}

/** The slider's own positions. */
export const positions = 100;

/** Where the state has not followed the hand by then, it will not. */
const followMs = 250;

interface SliderProps {
  readonly label: string;
  readonly value: number;
  readonly scale: Scale;
  /** As people read it. */
  readonly text: (value: number) => string;
  readonly onInput: (value: number) => void;
  /** Words at both ends say it all: name and value are only read out. */
  readonly ends?: readonly [least: string, most: string];
}

function SliderEnd({ word }: { readonly word: string }) {
  return (
    <span class="slider-end" aria-hidden="true">
      {word}
    </span>
  );
}

/** A slider with its name and its value. It stays under the hand while the core is still at work on the value before. */
export function Slider({ label, value, scale, text, onInput, ends }: SliderProps) {
  const id = useId();
  const [held, hold] = useState<number | null>(null);
  const take = useRef(onInput);
  take.current = onInput;
  const values = useMemo(() => {
    return eachFrame<number>((next) => {
      take.current(next);
    });
  }, []);
  const timer = useRef(0);
  useEffect(
    () => () => {
      clearTimeout(timer.current);
    },
    [],
  );
  const shown = held ?? value;
  const position = scale.toPosition(shown);

  function onRangeInput(event: Event & { currentTarget: HTMLInputElement }): void {
    clearTimeout(timer.current);
    const next = scale.toValue(Number(event.currentTarget.value));
    hold(next);
    values.put(next);
  }

  function onRangeChange(): void {
    values.flush();
    timer.current = window.setTimeout(() => {
      hold(null);
    }, followMs);
  }

  return (
    <div class="slider">
      <label for={id} class={ends && "visually-hidden"}>
        {label}
      </label>
      {ends && <SliderEnd word={ends[0]} />}
      <input
        id={id}
        type="range"
        min={0}
        max={positions}
        step={1}
        value={position}
        style={{ "--filled": `${position}%` }}
        aria-valuetext={text(shown)}
        onInput={onRangeInput}
        onChange={onRangeChange}
      />
      {ends ? <SliderEnd word={ends[1]} /> : <output for={id}>{text(shown)}</output>}
    </div>
  );
}
