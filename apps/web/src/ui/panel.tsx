// SPDX-License-Identifier: Apache-2.0
import { X } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useId, useRef } from "preact/hooks";
import "../styles/panel.css";
import { IconButton } from "./icon-button";
import { useStudio } from "./studio-context";
import { useBorrowedFocus, useDismissal } from "./use-dismissal";
import { useSheetDrag } from "./use-sheet-drag";

export interface PanelProps {
  readonly title: string;
  readonly onClose: () => void;
  /** On wide screens; on narrow ones all but "top" are sheets that slide up. */
  readonly place?: "right" | "middle" | "top";
  readonly isLarge?: boolean;
  /** There is more to read than to press: Tab reaches what scrolls. */
  readonly isReading?: boolean;
  /** Stands between the title and what scrolls: a search field, tabs. */
  readonly head?: ComponentChildren;
  /** Stands below what scrolls: the primary button. */
  readonly foot?: ComponentChildren;
  readonly children: ComponentChildren;
}

/**
 * A panel over the canvas; the drawing stays in reach beside it. Takes the focus to the element marked data-first-focus, or to
 * itself; Esc, the cross and a press outside close it, and the focus goes back.
 */
export function Panel(props: PanelProps) {
  const studio = useStudio();
  const titleId = useId();
  const root = useRef<HTMLElement>(null);
  const sheet = useSheetDrag(props.onClose);
  // In this order: closing gives the focus back after the listeners have gone.
  useDismissal(root, props.onClose);
  useBorrowedFocus(root);
  const place = props.place ?? "right";
  const size = props.isLarge === true ? " panel-large" : "";

  return (
    <section
      ref={root}
      class={`panel surface-raised panel-${place}${size}`}
      role="dialog"
      aria-modal="false"
      aria-labelledby={titleId}
      tabIndex={-1}
      data-height={sheet.height}
      data-dragged={sheet.isDragged}
      style={{ "--dragged": `${sheet.movedPx}px` }}
    >
      <div class="panel-handle" aria-hidden="true" {...sheet.handle} />
      <div class="panel-header">
        <h2 id={titleId} class="panel-title">
          {props.title}
        </h2>
        <IconButton icon={X} label={studio.word("close")} onClick={props.onClose} />
      </div>
      {props.head}
      <div class="panel-body" tabIndex={props.isReading === true ? 0 : undefined}>
        {props.children}
      </div>
      {props.foot !== undefined && <div class="panel-foot">{props.foot}</div>}
    </section>
  );
}
