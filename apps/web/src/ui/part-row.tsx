// SPDX-License-Identifier: Apache-2.0
import { Eye, EyeOff, GripVertical, Lock, LockOpen } from "lucide-preact";
import type { LayerRow } from "../protocol/state";
import { partName } from "./part-name";
import { PartRename } from "./part-rename";
import { PartThumbnail } from "./part-thumbnail";
import "../styles/controls.css";
import { useStudio } from "./studio-context";

export interface PartRowProps {
  readonly part: LayerRow;
  /** Of all rows, one is reached with Tab. */
  readonly isReached: boolean;
  readonly isDragged: boolean;
  readonly isRenamed: boolean;
  /** The line that shows where a dragged row would fall. */
  readonly line: "before" | "after" | null;
  readonly onClick: (event: MouseEvent) => void;
  readonly onFocus: () => void;
  readonly onRename: () => void;
  readonly onRenamed: (name: string | null) => void;
  readonly onDrag: (event: PointerEvent, isHandle: boolean) => void;
}

function PartSwitches({ part, isReached }: Pick<PartRowProps, "part" | "isReached">) {
  const studio = useStudio();
  const name = partName(studio, part);
  const tabIndex = isReached ? 0 : -1;
  const visibleLabel = studio.word(part.isHidden ? "show_part_named" : "hide_part_named", name);
  const lockedLabel = studio.word(part.isLocked ? "unlock_part_named" : "lock_part_named", name);
  const id = String(part.id);
  return (
    <>
      <button
        type="button"
        class="part-switch"
        data-on={part.isLocked}
        tabIndex={tabIndex}
        aria-label={lockedLabel}
        data-tip={lockedLabel}
        onClick={() => {
          studio.act("lock_part", id);
        }}
      >
        {part.isLocked ? <Lock size={15} /> : <LockOpen size={15} />}
      </button>
      <button
        type="button"
        class="part-switch"
        data-on={part.isHidden}
        tabIndex={tabIndex}
        aria-label={visibleLabel}
        data-tip={visibleLabel}
        onClick={() => {
          studio.act("hide_part", id);
        }}
      >
        {part.isHidden ? <EyeOff size={15} /> : <Eye size={15} />}
      </button>
    </>
  );
}

/** One part in the stack: picture and name choose it; beside them its switches. */
export function PartRow(props: PartRowProps) {
  const studio = useStudio();
  const { part } = props;
  const name = partName(studio, part);
  const claims = [
    part.isHidden && studio.word("part_is_hidden"),
    part.isLocked && studio.word("part_is_locked"),
    part.isOpen && studio.word("part_is_open"),
  ].filter((claim) => claim !== false);

  return (
    <li
      class="part-row"
      data-part={part.id}
      data-selected={part.isSelected}
      data-hidden={part.isHidden}
      data-dragged={props.isDragged}
      data-line={props.line}
    >
      <span
        class="part-grip"
        aria-hidden="true"
        onPointerDown={(event) => {
          props.onDrag(event, true);
        }}
      >
        <GripVertical size={14} />
      </span>
      <button
        type="button"
        class="part-choose"
        aria-pressed={part.isSelected}
        tabIndex={props.isReached ? 0 : -1}
        onClick={props.onClick}
        onDblClick={props.onRename}
        onFocus={props.onFocus}
        onPointerDown={(event) => {
          props.onDrag(event, false);
        }}
      >
        <PartThumbnail part={part} />
        {!props.isRenamed && (
          <span class="part-label">
            <span class="part-name">{name}</span>
            {part.isOpen && <span class="part-claim">{studio.word("part_is_open")}</span>}
          </span>
        )}
        <span class="visually-hidden">{claims.join(", ")}</span>
      </button>
      {props.isRenamed && <PartRename name={name} onDone={props.onRenamed} />}
      <PartSwitches part={part} isReached={props.isReached} />
    </li>
  );
}
