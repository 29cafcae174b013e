// SPDX-License-Identifier: Apache-2.0
import { useLayoutEffect, useRef } from "preact/hooks";
import { useStudio } from "./studio-context";

interface PartRenameProps {
  readonly name: string;
  /** null: it keeps its name. */
  readonly onDone: (name: string | null) => void;
}

/** The name of a part as a field: Enter or leaving it takes the name, Esc keeps the old one. */
export function PartRename({ name, onDone }: PartRenameProps) {
  const studio = useStudio();
  const field = useRef<HTMLInputElement>(null);
  // Leaving the field after Esc must not take what was typed.
  const isOver = useRef(false);

  useLayoutEffect(() => {
    field.current?.focus();
    field.current?.select();
  }, []);

  const finish = (taken: string | null) => {
    if (isOver.current) return;
    isOver.current = true;
    onDone(taken === "" || taken === name ? null : taken);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    // Neither the list nor the core may take what is typed here for their keys.
    event.stopPropagation();
    if (event.key === "Enter") finish(field.current?.value.trim() ?? null);
    if (event.key === "Escape") finish(null);
  };

  return (
    <input
      ref={field}
      class="part-rename"
      type="text"
      maxLength={80}
      defaultValue={name}
      aria-label={studio.label("rename_part")}
      onKeyDown={onKeyDown}
      onBlur={() => {
        finish(field.current?.value.trim() ?? null);
      }}
    />
  );
}
