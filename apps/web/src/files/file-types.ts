// SPDX-License-Identifier: Apache-2.0
import type { FileUse } from "../protocol/events";

/** docs/LIMITS.md: the core takes no more; asked here before anything is read. */
export const mostFileBytes = 64 * 1024 * 1024;

const pictures = { "image/png": [".png"], "image/jpeg": [".jpg", ".jpeg"] } as const;
const drawings = {
  "application/vnd.inkflate+zip": [".inkflate"],
  "image/svg+xml": [".svg"],
  "application/zip": [".zip"],
  "text/x-scap": [".scap"],
} as const;

/** What a dialog offers for a use, by type and extension. */
export function acceptedFor(use: FileUse): Readonly<Record<string, readonly string[]>> {
  return use === "template" ? pictures : { ...drawings, ...pictures };
}

/** The type to hand out bytes as, by the name's extension. */
export function mimeTypeOf(name: string): string {
  const extension = extensionOf(name);
  return mimeTypes[extension] ?? "application/octet-stream";
}

const mimeTypes: Readonly<Record<string, string>> = {
  ".inkflate": "application/vnd.inkflate+zip",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".zip": "application/zip",
  ".glb": "model/gltf-binary",
  ".obj": "model/obj",
  ".mtl": "model/mtl",
  ".stl": "model/stl",
  ".3mf": "model/3mf",
};

/** ".svg" of "Mouse.SVG"; "": none. */
export function extensionOf(name: string): string {
  return /\.[^./\\]+$/.exec(name)?.[0].toLowerCase() ?? "";
}

/** "mouse" of "mouse.inkflate", as the core names a drawing. */
export function stemOf(name: string): string {
  const extension = extensionOf(name);
  return extension.length < name.length ? name.slice(0, name.length - extension.length) : name;
}

/** Pixels, not lines. The core goes by the bytes; this only decides what to offer. */
export function isPicture(file: { readonly name: string; readonly type: string }): boolean {
  if (file.type !== "") return file.type.startsWith("image/") && file.type !== "image/svg+xml";
  return [".png", ".jpg", ".jpeg"].includes(extensionOf(file.name));
}
