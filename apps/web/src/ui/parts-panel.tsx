// SPDX-License-Identifier: Apache-2.0
import { ChevronDown } from "lucide-preact";
import { useId, useState } from "preact/hooks";
import "../styles/parts-panel.css";
import { isNarrow } from "./narrow";
import { Panel } from "./panel";
import { PartDetails } from "./part-details";
import { PartsList } from "./parts-list";
import { useKey } from "./use-key";
import { useStudio } from "./studio-context";

function PartsContent() {
  const studio = useStudio();
  const parts = studio.state.value.layers;
  const selected = parts.filter((part) => part.isSelected);
  const [renamed, setRenamed] = useState<number | null>(null);
  const onlyOne = selected.length === 1 ? selected[0]?.id : undefined;
  useKey("F2", () => {
    if (onlyOne !== undefined) setRenamed(onlyOne);
  });
  if (parts.length === 0) return <p class="parts-empty">{studio.word("parts_empty")}</p>;
  return (
    <>
      <PartsList renamed={renamed} onRename={setRenamed} />
      {selected.length > 0 && <PartDetails selected={selected} onRename={setRenamed} />}
    </>
  );
}

/** Beside the drawing, and folded away when it is in the way. */
function PartsDock() {
  const studio = useStudio();
  const [isOpen, setIsOpen] = useState(true);
  const bodyId = useId();
  const count = studio.state.value.layers.length;
  return (
    <aside class="parts parts-dock surface" aria-label={studio.word("parts")} data-open={isOpen}>
      <button
        type="button"
        class="parts-fold"
        aria-expanded={isOpen}
        aria-controls={bodyId}
        onClick={() => {
          setIsOpen(!isOpen);
        }}
      >
        <span class="parts-title">{studio.word("parts")}</span>
        {count > 0 && <span class="parts-number">{count}</span>}
        <ChevronDown size={16} aria-hidden="true" />
      </button>
      <div id={bodyId} class="parts-body" hidden={!isOpen}>
        {isOpen && <PartsContent />}
      </div>
    </aside>
  );
}

/** The parts of the drawing: in their place of the frame where the window is wide, a sheet where it is narrow. */
export function PartsPanel() {
  const studio = useStudio();
  if (!isNarrow.value) return <PartsDock />;
  if (studio.panel.value !== "parts") return null;
  const close = () => {
    studio.panel.value = null;
  };
  return (
    <Panel title={studio.word("parts")} onClose={close}>
      <PartsContent />
    </Panel>
  );
}
