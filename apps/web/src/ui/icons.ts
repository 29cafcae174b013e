// SPDX-License-Identifier: Apache-2.0
import { createLucideIcon } from "lucide-preact";

/** All icons of the studio: one set, and in its style what the set lacks. */

export type { LucideIcon as Icon } from "lucide-preact";
export {
  ArrowDown as TurnDownIcon,
  ArrowLeft as TurnLeftIcon,
  ArrowRight as TurnRightIcon,
  ArrowUp as TurnUpIcon,
  Balloon as InflateIcon,
  Brush as BrushIcon,
  Check as CheckIcon,
  ChevronDown as ChevronDownIcon,
  CircleQuestionMark as HelpIcon,
  Copy as DuplicateIcon,
  Eraser as EraserIcon,
  FilePlus as NewIcon,
  FolderOpen as OpenIcon,
  Hand as HandIcon,
  History as SessionsIcon,
  ImageOff as RemovePictureIcon,
  ImagePlus as AddPictureIcon,
  Languages as LanguageIcon,
  Layers as PartsIcon,
  LoaderCircle as SavingIcon,
  Maximize as FitIcon,
  Menu as MenuIcon,
  Minus as MinusIcon,
  MousePointer2 as SelectIcon,
  PencilLine as DrawIcon,
  Pipette as OtherColourIcon,
  Plus as PlusIcon,
  Redo2 as RedoIcon,
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

/** A dashed stroke between two ends. */
export const HelpLineIcon = createLucideIcon("help-line", [
  ["path", { d: "M4 19C5.5 11.5 12.5 17 14.5 11.5S18 5.5 20 5", "stroke-dasharray": "3 3.6" }],
]);

/** A place inside of a bay. */
export const MarkIcon = createLucideIcon("mark", [
  ["path", { d: "M6.5 4.5C3.5 7 3 12 4.5 15.5S9.5 20.5 13 20s6.5-3 7-7-1.5-7-3.5-8.5" }],
  ["path", { d: "m9.5 9 5 5" }],
  ["path", { d: "m14.5 9-5 5" }],
]);

/** A part before, or behind, a dashed one. */
export const NearerIcon = createLucideIcon("nearer", [
  ["rect", { x: "9", y: "9", width: "11", height: "11", rx: "2.5" }],
  [
    "path",
    {
      d: "M5.5 14.5A1.5 1.5 0 0 1 4 13V6a2 2 0 0 1 2-2h7a1.5 1.5 0 0 1 1.5 1.5",
      "stroke-dasharray": "2 2.6",
    },
  ],
  ["path", { d: "M14.5 17v-5" }],
  ["path", { d: "m12.3 14 2.2-2.2 2.2 2.2" }],
]);

export const FartherIcon = createLucideIcon("farther", [
  ["rect", { x: "9", y: "9", width: "11", height: "11", rx: "2.5" }],
  [
    "path",
    {
      d: "M5.5 14.5A1.5 1.5 0 0 1 4 13V6a2 2 0 0 1 2-2h7a1.5 1.5 0 0 1 1.5 1.5",
      "stroke-dasharray": "2 2.6",
    },
  ],
  ["path", { d: "M14.5 12v5" }],
  ["path", { d: "m12.3 15 2.2 2.2 2.2-2.2" }],
]);

/** A face looked at from the front. */
export const FrontIcon = createLucideIcon("front", [
  ["path", { d: "M4 8V6a2 2 0 0 1 2-2h2" }],
  ["path", { d: "M16 4h2a2 2 0 0 1 2 2v2" }],
  ["path", { d: "M20 16v2a2 2 0 0 1-2 2h-2" }],
  ["path", { d: "M8 20H6a2 2 0 0 1-2-2v-2" }],
  ["circle", { cx: "12", cy: "12", r: "3.5" }],
]);
