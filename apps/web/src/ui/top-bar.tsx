// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "../protocol/actions.generated";
import { drawingName } from "../studio/drawing-name";
import type { Panel } from "../studio/studio";
import { useEdgeHeight } from "./edge-heights";
import { IconButton } from "./icon-button";
import { ExportIcon, HelpIcon, MenuIcon, PartsIcon, RedoIcon, UndoIcon, type Icon } from "./icons";
import { ModeSwitch } from "./mode-switch";
import { SaveMark } from "./save-mark";
import { useStudio } from "./studio-context";
import "../styles/top-bar.css";

function PanelButton(props: {
  readonly panel: Panel;
  readonly icon: Icon;
  readonly label: string;
  readonly action?: ActionName;
}) {
  const studio = useStudio();
  const { panel, action } = props;
  const isOpen = studio.panel.value === panel;
  return (
    <IconButton
      icon={props.icon}
      label={props.label}
      chord={action === undefined ? "" : studio.chord(action)}
      isExpanded={isOpen}
      isEnabled={action === undefined || studio.isEnabled(action)}
      onClick={() => {
        studio.panel.value = isOpen ? null : panel;
      }}
    />
  );
}

/** Says what it would take back. */
function HistoryButton({ action, icon }: { action: "undo" | "redo"; icon: Icon }) {
  const studio = useStudio();
  const what = studio.state.value[action];
  const name = studio.label(action);
  return (
    <IconButton
      icon={icon}
      label={what === null ? name : `${name}: ${studio.label(what)}`}
      chord={studio.chord(action)}
      isEnabled={what !== null}
      onClick={() => {
        studio.act(action);
      }}
    />
  );
}

function DrawingName() {
  const studio = useStudio();
  const { fileName } = studio.state.value;
  return (
    <div class="drawing-name">
      <h1>{drawingName(studio, fileName)}</h1>
      <SaveMark />
    </div>
  );
}

/** Where the parts are when there is no room for them beside the drawing. */
function PartsButton() {
  const studio = useStudio();
  const count = studio.state.value.layers.length;
  return (
    <div class="parts-button surface">
      <PanelButton panel="parts" icon={PartsIcon} label={studio.word("parts_count", count)} />
      {count > 0 && (
        <span class="parts-badge" aria-hidden="true">
          {count}
        </span>
      )}
    </div>
  );
}

export function TopBar() {
  const studio = useStudio();
  return (
    <header class="top-bar" ref={useEdgeHeight<HTMLElement>("head")}>
      <div class="top-start">
        <div class="top-piece surface">
          <PanelButton panel="menu" icon={MenuIcon} label={studio.word("menu")} />
          <DrawingName />
        </div>
      </div>
      <ModeSwitch />
      <div class="top-end" data-tip-side="bottom">
        <div class="top-piece surface">
          <HistoryButton action="undo" icon={UndoIcon} />
          <HistoryButton action="redo" icon={RedoIcon} />
        </div>
        <div class="top-piece top-more surface">
          <PanelButton
            panel="export"
            icon={ExportIcon}
            label={studio.label("export")}
            action="export"
          />
          <PanelButton panel="help" icon={HelpIcon} label={studio.label("help")} action="help" />
        </div>
        <PartsButton />
      </div>
    </header>
  );
}
