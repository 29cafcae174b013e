// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from "preact";
import { useRef, useState } from "preact/hooks";
import type { Icon } from "./icons";
import { IconButton } from "./icon-button";
import { useOutside } from "./use-dismissal";
import "../styles/popover.css";

interface PopoverProps {
  readonly icon: Icon;
  readonly label: string;
  readonly children: ComponentChildren;
}

/** A button with what it opens above it; a press anywhere else or Esc closes it. */
export function Popover({ icon, label, children }: PopoverProps) {
  const frame = useRef<HTMLDivElement>(null);
  const [isOpen, setOpen] = useState(false);
  useOutside(frame, isOpen, () => {
    setOpen(false);
  });
  return (
    <div class="popover" ref={frame}>
      <IconButton
        icon={icon}
        label={label}
        isExpanded={isOpen}
        onClick={() => {
          setOpen(!isOpen);
        }}
      />
      {isOpen && (
        <div class="popover-content surface-raised" role="group" aria-label={label}>
          {children}
        </div>
      )}
    </div>
  );
}
