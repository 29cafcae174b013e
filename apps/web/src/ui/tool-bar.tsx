// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "../protocol/actions.generated";
import type { Tool } from "../protocol/state";
import { IconButton } from "./icon-button";
import {
  BendIcon,
  BrushIcon,
  EraserIcon,
  HandIcon,
  HelpLineIcon,
  MarkIcon,
  SelectIcon,
  type Icon,
} from "./icons";
import { useRoving } from "./roving";
import { useStudio } from "./studio-context";
import "../styles/tool-bar.css";

interface ToolRow {
  readonly tool: Tool;
  readonly action: ActionName;
  readonly icon: Icon;
}

/** Each group is set apart: what makes ink, what tells the shape, what handles. */
const groups: readonly (readonly ToolRow[])[] = [
  [
    { tool: "brush", action: "brush", icon: BrushIcon },
    { tool: "help_line", action: "help_line", icon: HelpLineIcon },
    { tool: "eraser", action: "eraser", icon: EraserIcon },
  ],
  [
    { tool: "mark", action: "mark", icon: MarkIcon },
    { tool: "select", action: "select_tool", icon: SelectIcon },
    { tool: "deform", action: "deform", icon: BendIcon },
    { tool: "hand", action: "hand", icon: HandIcon },
  ],
];

export function ToolBar() {
  const studio = useStudio();
  const roving = useRoving<HTMLDivElement>("both");
  const { tool, mode } = studio.state.value;
  const button = (row: ToolRow) => (
    <IconButton
      key={row.tool}
      icon={row.icon}
      label={studio.label(row.action)}
      chord={studio.chord(row.action)}
      isPressed={mode === "draw" && tool === row.tool}
      isRoving
      onClick={() => {
        studio.act(row.action);
      }}
    />
  );
  return (
    <div
      {...roving}
      class="tool-bar surface"
      role="toolbar"
      aria-label={studio.word("tools")}
      data-tip-side="right"
      data-is-away={mode !== "draw"}
    >
      {groups.map((rows, index) => (
        <div key={index} class="tool-group" style={{ "--count": rows.length }}>
          {rows.map(button)}
        </div>
      ))}
    </div>
  );
}
