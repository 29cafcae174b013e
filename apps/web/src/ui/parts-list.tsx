// SPDX-License-Identifier: Apache-2.0
import { useId, useLayoutEffect, useRef, useState } from "preact/hooks";
import type { LayerRow } from "../protocol/state";
import { neighbouringGap, placeFromBack } from "./part-order";
import { PartRow } from "./part-row";
import { selectArgument, selectionAfterClick } from "./part-selection";
import "../styles/controls.css";
import { useStudio } from "./studio-context";
import { usePartDrag } from "./use-part-drag";

interface PartsListProps {
  readonly renamed: number | null;
  readonly onRename: (id: number | null) => void;
}

/** The parts in depth order, the nearest on top: one Tab stop, arrows within. */
export function PartsList({ renamed, onRename }: PartsListProps) {
  const studio = useStudio();
  const parts = studio.state.value.layers;
  const ids = parts.map((part) => part.id);
  const list = useRef<HTMLUListElement>(null);
  const [focused, setFocused] = useState<number | null>(null);
  const anchor = useRef<number | null>(null);
  const helpId = useId();

  const select = (chosen: readonly number[]) => {
    studio.act("select", selectArgument(chosen));
  };
  const moveRow = (from: number, gap: number | null) => {
    const part = parts[from];
    const place = gap === null ? null : placeFromBack(parts.length, from, gap);
    if (part === undefined || place === null) return;
    select([part.id]);
    studio.act("move_part", String(place));
  };
  const drag = usePartDrag(list, moveRow);

  const reached =
    parts.find((part) => part.id === focused) ?? parts.find((part) => part.isSelected);
  const reachedId = (reached ?? parts[0])?.id;

  const onClick = (part: LayerRow, event: MouseEvent) => {
    if (!drag.isClick()) return;
    const selected = parts.filter((each) => each.isSelected).map((each) => each.id);
    const isToggle = event.ctrlKey || event.metaKey;
    const click = { id: part.id, isRange: event.shiftKey, isToggle };
    select(selectionAfterClick(ids, selected, anchor.current, click));
    if (!event.shiftKey) anchor.current = part.id;
  };
  const focusRow = (index: number) => {
    const id = ids[index];
    if (id === undefined) return;
    list.current?.querySelector<HTMLElement>(`[data-part="${id}"] .part-choose`)?.focus();
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const at = ids.findIndex((id) => id === reachedId);
    const isUp = event.key === "ArrowUp";
    if (isUp || event.key === "ArrowDown") {
      if (event.altKey) moveRow(at, neighbouringGap(ids.length, at, isUp ? "nearer" : "farther"));
      else focusRow(at + (isUp ? -1 : 1));
    } else if (event.key === "F2") {
      onRename(reachedId ?? null);
    } else if (event.key === "Delete" || event.key === "Backspace") {
      // The row with the focus is meant, whatever is selected.
      if (reached?.isSelected !== true && reachedId !== undefined) select([reachedId]);
      studio.act("delete");
    } else {
      return;
    }
    // These keys mean something else to the drawing.
    event.stopPropagation();
    event.preventDefault();
  };

  useKeptFocus(list, ids, focused, focusRow);

  const finishRename = (part: LayerRow, name: string | null) => {
    onRename(null);
    if (name !== null) {
      select([part.id]);
      studio.act("rename_part", name);
    }
    focusRow(ids.indexOf(part.id));
  };
  const lineOf = (index: number): "before" | "after" | null => {
    if (drag.shown?.gap === index) return "before";
    return index === parts.length - 1 && drag.shown?.gap === parts.length ? "after" : null;
  };

  return (
    <>
      <p id={helpId} class="visually-hidden">
        {studio.word("parts_keys")}
      </p>
      <ul
        ref={list}
        class="parts-list"
        aria-label={studio.word("parts")}
        aria-describedby={helpId}
        onKeyDown={onKeyDown}
        {...drag.listeners}
      >
        {parts.map((part, index) => (
          <PartRow
            key={part.id}
            part={part}
            isReached={part.id === reachedId}
            isDragged={drag.shown?.from === index}
            isRenamed={renamed === part.id}
            line={lineOf(index)}
            onClick={(event) => {
              onClick(part, event);
            }}
            onFocus={() => {
              setFocused(part.id);
            }}
            onRename={() => {
              onRename(part.id);
            }}
            onRenamed={(name) => {
              finishRename(part, name);
            }}
            onDrag={(event, isHandle) => {
              drag.onPointerDown(event, index, isHandle);
            }}
          />
        ))}
      </ul>
    </>
  );
}

/**
 * A row that is moved loses the focus with its element, and one that goes takes it along: it comes back to the row, or to its
 * neighbour. Else the next key would start from the top of the page.
 */
function useKeptFocus(
  list: { readonly current: HTMLElement | null },
  ids: readonly number[],
  focused: number | null,
  focusRow: (index: number) => void,
): void {
  const before = useRef(ids);
  const hadFocus = list.current?.contains(document.activeElement) === true;
  useLayoutEffect(() => {
    const at = focused === null ? -1 : before.current.indexOf(focused);
    before.current = ids;
    if (!hadFocus || focused === null || document.activeElement !== document.body) return;
    focusRow(ids.includes(focused) ? ids.indexOf(focused) : Math.min(at, ids.length - 1));
  });
}
