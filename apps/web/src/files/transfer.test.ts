// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from "vitest";
import { filesOf } from "./transfer";

function transfer(texts: Record<string, string>, files: File[] = []) {
  return { files, getData: (type: string) => texts[type] ?? "" };
}

describe("filesOf", () => {
  it.each([
    "<svg xmlns='http://www.w3.org/2000/svg'/>",
    '<?xml version="1.0"?>\n<!-- by hand -->\n<!DOCTYPE svg PUBLIC "a" "b">\n<svg>',
    "  <SVG\n>",
  ])("takes a text of SVG for a file: %s", async (text) => {
    const [file] = filesOf(transfer({ "text/plain": text }), "pasted.svg");
    expect([file?.name, file?.type, await file?.text()]).toEqual([
      "pasted.svg",
      "image/svg+xml",
      text,
    ]);
  });

  it.each(["", "hello", "<html><svg></svg></html>", "<svgx>", "see <svg>"])(
    "takes no other text: %s",
    (text) => {
      expect(filesOf(transfer({ "text/plain": text }), "pasted.svg")).toEqual([]);
    },
  );

  it("prefers files to their texts", () => {
    const file = new File(["1"], "a.png");
    expect(filesOf(transfer({ "text/plain": "<svg>" }, [file]), "pasted.svg")).toEqual([file]);
  });

  it("ends soon with hostile texts", () => {
    const text = `<?xml ${"<!-- ".repeat(100_000)}`;
    expect(filesOf(transfer({ "text/plain": text }), "pasted.svg")).toEqual([]);
  });
});
