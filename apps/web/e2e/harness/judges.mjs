// SPDX-License-Identifier: Apache-2.0
// What others say about the files that leave the studio.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import validator from "gltf-validator";

/** Khronos' own validator finds nothing to say, not even a warning. */
export async function assertValidGlb(bytes) {
  const { issues, info } = await validator.validateBytes(new Uint8Array(bytes));
  assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages));
  assert.ok(info.totalTriangleCount > 100, `only ${info.totalTriangleCount} triangles`);
}

/** Each edge of a binary STL is there as often in one direction as in the other: it encloses a volume. */
export function assertClosedStl(bytes) {
  const triangles = bytes.readUInt32LE(80);
  assert.equal(bytes.length, 84 + 50 * triangles);
  assert.ok(triangles > 100, `only ${triangles} triangles`);
  const balance = new Map();
  for (let triangle = 0; triangle < triangles; ++triangle) {
    const start = 84 + 50 * triangle + 12;
    const corners = [0, 12, 24].map((at) => bytes.toString("hex", start + at, start + at + 12));
    for (let side = 0; side < 3; ++side) {
      const [a, b] = [corners[side], corners[(side + 1) % 3]];
      const [edge, direction] = a < b ? [a + b, 1] : [b + a, -1];
      balance.set(edge, (balance.get(edge) ?? 0) + direction);
    }
  }
  const open = [...balance.values()].filter((value) => value !== 0).length;
  assert.equal(open, 0, `${open} open edges`);
}

/** What a printer's own checker says, where it is installed. */
export function assertPrintable(bytes) {
  const folder = mkdtempSync(join(tmpdir(), "inkflate-"));
  const file = join(folder, "model.stl");
  writeFileSync(file, bytes);
  const { stdout, error } = spawnSync("admesh", [file], { encoding: "utf8" });
  rmSync(folder, { recursive: true });
  if (error !== undefined) return;
  const wrong = /(Total disconnected facets|Degenerate facets|Facets reversed) *: +([0-9]+)/g;
  for (const [, what, count] of stdout.matchAll(wrong))
    assert.equal(`${what} ${count}`, `${what} 0`);
}

/** Nothing in an SVG that could do or load anything; what its texts say is free. */
export function assertInertSvg(text) {
  const bare = text.replaceAll(/"[^"]*"|'[^']*'/g, '""').replaceAll(/>[^<]*</g, "><");
  assert.doesNotMatch(bare, /<(script|foreignObject|iframe|set|animate|!ENTITY|!DOCTYPE)/i);
  assert.doesNotMatch(bare, /\son[a-z]+\s*=/i);
  for (const [, target] of text.matchAll(/\shref\s*=\s*["']([^"']*)/gi)) {
    assert.match(target, /^(#|data:image\/png;base64,)/);
  }
}
