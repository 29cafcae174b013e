// SPDX-License-Identifier: Apache-2.0
import type { Word } from "../studio/words";

export interface ExportFormat {
  readonly extension: string;
  readonly name: Word;
  readonly holds: Word;
}

/** All that the core writes; those for the model first, since that is what most people come for. */
export const exportFormats = [
  { extension: "glb", name: "export_glb", holds: "export_glb_holds" },
  { extension: "stl", name: "export_stl", holds: "export_stl_holds" },
  { extension: "3mf", name: "export_3mf", holds: "export_3mf_holds" },
  { extension: "obj", name: "export_obj", holds: "export_obj_holds" },
  { extension: "png", name: "export_png", holds: "export_png_holds" },
  { extension: "svg", name: "export_svg", holds: "export_svg_holds" },
  { extension: "inkflate", name: "export_inkflate", holds: "export_inkflate_holds" },
  { extension: "zip", name: "export_zip", holds: "export_zip_holds" },
] as const satisfies readonly ExportFormat[];

export type ExportExtension = (typeof exportFormats)[number]["extension"];

const kilobyte = 1000;
const megabyte = 1000 * kilobyte;

/** "340 kB", "1.4 MB" as the language writes it. */
export function sizeText(bytes: number, language: string): string {
  const isLarge = bytes >= megabyte;
  const format = new Intl.NumberFormat(language, {
    style: "unit",
    unit: isLarge ? "megabyte" : "kilobyte",
    maximumSignificantDigits: 2,
  });
  // Rounded up: no file has 0 kB.
  return format.format(isLarge ? bytes / megabyte : Math.max(1, Math.ceil(bytes / kilobyte)));
}
