// SPDX-License-Identifier: Apache-2.0
import { Ban, TextCursorInput } from "lucide-preact";
import type { ActionName } from "../protocol/actions.generated";
import type { EngineState, LayerRow } from "../protocol/state";
import "../styles/part-details.css";
import { ActionButton, IconButton } from "./icon-button";
import { DeleteIcon, DuplicateIcon, EditLinesIcon, FartherIcon, NearerIcon } from "./icons";
import { isNarrow } from "./narrow";
import { partName } from "./part-name";
import { Fill, Thickness } from "./part-settings";
import { useStudio } from "./studio-context";

interface PartDetailsProps {
  readonly selected: readonly LayerRow[];
  readonly onRename: (id: number) => void;
}

/** Colours to tap, and none: then the part looks as its drawing does. */
function FillRow({ part }: { readonly part: LayerRow }) {
  const studio = useStudio();
  return (
    <div class="part-fill">
      <IconButton
        icon={Ban}
        label={studio.word("colour_none")}
        isPressed={part.fill === null}
        onClick={() => {
          studio.act("fill", "none");
        }}
      />
      <Fill colour={part.fill} />
    </div>
  );
}

function LinesRow({ isOpen }: { readonly isOpen: boolean }) {
  const studio = useStudio();
  const edit: ActionName = isOpen ? "close_part" : "open_part";
  return (
    <div class="part-lines">
      <button
        type="button"
        class="part-button"
        onClick={() => {
          studio.act(edit);
        }}
      >
        <EditLinesIcon aria-hidden="true" />
        {studio.word(isOpen ? "stop_editing" : "edit_lines")}
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
  );
}

function OrderRow() {
  return (
    <div class="part-actions">
      <ActionButton icon={NearerIcon} action="depth_nearer" />
      <ActionButton icon={FartherIcon} action="depth_farther" />
      <ActionButton icon={DuplicateIcon} action="duplicate" />
      <ActionButton icon={DeleteIcon} action="delete" tone="danger" />
    </div>
  );
}

/** The bar below the drawing has the same buttons while parts are being selected in it; there they are nearer to the hand. */
function hasOrderBelow({ mode, tool }: EngineState): boolean {
  return !isNarrow.value && mode === "draw" && tool === "select";
}

/** Everything about the parts that are selected. */
export function PartDetails({ selected, onRename }: PartDetailsProps) {
  const studio = useStudio();
  const [first] = selected;
  if (first === undefined) return null;
  const isOne = selected.length === 1;
  const name = isOne ? partName(studio, first) : studio.word("parts_selected", selected.length);
  return (
    <section class="part-details" aria-label={studio.word("part_details", name)}>
      <div class="part-heading">
        <span class="part-heading-name">{name}</span>
        <IconButton
          icon={TextCursorInput}
          label={studio.label("rename_part")}
          chord="F2"
          isEnabled={isOne}
          onClick={() => {
            onRename(first.id);
          }}
        />
      </div>
      <Thickness value={first.thickness} />
      <FillRow part={first} />
      {!hasOrderBelow(studio.state.value) && <OrderRow />}
      <LinesRow isOpen={selected.some((part) => part.isOpen)} />
    </section>
  );
}
