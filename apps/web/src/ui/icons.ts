// SPDX-License-Identifier: Apache-2.0
import { createLucideIcon } from "lucide-preact";

/** All icons of the studio: one set, and in its style what the set lacks. */

export type { LucideIcon as Icon } from "lucide-preact";
export {
  ArrowDown as TurnDownIcon,
  ArrowLeft as TurnLeftIcon,
  ArrowRight as TurnRightIcon,
  ArrowUp as TurnUpIcon,
  Brush as BrushIcon,
  Check as CheckIcon,
  CircleDotDashed as FreePinIcon,
  CircleQuestionMark as HelpIcon,
  Copy as DuplicateIcon,
  Eraser as EraserIcon,
  FilePlus as NewIcon,
  FolderOpen as OpenIcon,
  Hand as HandIcon,
  History as SessionsIcon,
  ImageOff as RemovePictureIcon,
  ImagePlus as AddPictureIcon,
  Layers as PartsIcon,
  LayersArrowDown as FartherIcon,
  LayersArrowUp as NearerIcon,
  LoaderCircle as SavingIcon,
  Maximize as FitIcon,
  Menu as MenuIcon,
  Minus as MinusIcon,
  MousePointer2 as SelectIcon,
  PinOff as RemovePinsIcon,
  Pipette as OtherColourIcon,
  Plus as PlusIcon,
  Redo2 as RedoIcon,
  RotateCcw as TurnPinLeftIcon,
  RotateCw as TurnPinRightIcon,
  Save as SaveIcon,
  Search as PaletteIcon,
  Settings as SettingsIcon,
  Shapes as ExamplesIcon,
  Share as ExportIcon,
  SlidersHorizontal as AdjustIcon,
  SplinePointer as EditLinesIcon,
  Trash as DeleteIcon,
  TrianglesCenterlineDashedHorizontal as FlipVerticalIcon,
  TrianglesCenterlineDashedVertical as FlipHorizontalIcon,
  TriangleAlert as WarningIcon,
  Undo2 as UndoIcon,
} from "lucide-preact";

/** A dashed stroke from one end to the other. */
export const HelpLineIcon = createLucideIcon("help-line", [
  [
    "path",
    { d: "M2.5 20.5c.8-8.5 4.5-9.700 9.5-8.5s8.700 0 9.5-8.5", "stroke-dasharray": "4 3.45" },
  ],
]);

/** A cross in a bay: this is not part of the shape. */
export const MarkIcon = createLucideIcon("mark", [
  ["path", { d: "M7 3.2A10 10 0 1 0 17 3.2" }],
  ["path", { d: "m9 9 6 6" }],
  ["path", { d: "m15 9-6 6" }],
]);

/** A limb bent over, and the pin that holds its root. */
export const BendIcon = createLucideIcon("bend", [
  [
    "path",
    { d: "M3.5 21v-5.5A11.5 11.5 0 0 1 15 4h1.5a4 4 0 0 1 0 8H15a3.5 3.5 0 0 0-3.5 3.5V21" },
  ],
  ["circle", { cx: "7.5", cy: "16.5", r: "0.7", fill: "currentColor" }],
]);

/** The set's pin, with room for a plus. */
export const AddPinIcon = createLucideIcon("add-pin", [
  ["path", { d: "M12 17v5" }],
  [
    "path",
    {
      d: "M13 2H8a2 2 0 0 0 0 4 1 1 0 0 1 1 1v3.76a2 2 0 0 1-1.11 1.79l-1.78.9A2 2 0 0 0 5 15.24V16a1 1 0 0 0 1 1h12a1 1 0 0 0 1-1v-.76a2 2 0 0 0-1.11-1.79l-1.78-.9A2 2 0 0 1 15 10.76V10",
    },
  ],
  ["path", { d: "M19 2v6" }],
  ["path", { d: "M16 5h6" }],
]);

/** A face looked at from the front. */
export const FrontIcon = createLucideIcon("front", [
  ["path", { d: "M4 8V6a2 2 0 0 1 2-2h2" }],
  ["path", { d: "M16 4h2a2 2 0 0 1 2 2v2" }],
  ["path", { d: "M20 16v2a2 2 0 0 1-2 2h-2" }],
  ["path", { d: "M8 20H6a2 2 0 0 1-2-2v-2" }],
  ["circle", { cx: "12", cy: "12", r: "3.5" }],
]);
