// SPDX-License-Identifier: Apache-2.0

/** The parts of a DataTransfer that are read. */
export interface Transfer {
  readonly files: Iterable<File>;
  getData(type: string): string;
}

/** Texts that are a drawing, as drawing programs and editors put them on the clipboard. */
function isSvg(text: string): boolean {
  return /^\s*(<\?xml[^>]*>\s*)?(<!--[^]*?-->\s*|<!doctype[^>]*>\s*)*<svg[\s>]/i.test(
    text.slice(0, 4000),
  );
}

/** Files that were dropped or pasted; a text of SVG counts as one. */
export function filesOf(transfer: Transfer, textName: string): File[] {
  const files = [...transfer.files];
  if (files.length > 0) return files;
  const text = ["image/svg+xml", "text/plain"]
    .map((type) => transfer.getData(type))
    .find((each) => isSvg(each));
  return text === undefined ? [] : [new File([text], textName, { type: "image/svg+xml" })];
}

/** Texts are typed there: what is pasted belongs to them. */
export function isTextField(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || target.matches("input, textarea, select"))
  );
}
