// SPDX-License-Identifier: Apache-2.0
// node make-gallery.mjs: makes the studio's examples in build/gallery of the drawings in examples/, with the program
// build/release/inkflate: a project and a small picture of each. The same bytes each time.
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const top = fileURLToPath(new URL("../../..", import.meta.url));
const folder = join(top, "build/gallery");
const program = join(top, "build/release/inkflate");
const picturePx = 240;
const turnDegrees = 25;

function inkflate(...words) {
  execFileSync(program, [...words, "--quiet"], { stdio: ["ignore", "ignore", "inherit"] });
}

/** As it was drawn: the strokes are loose, and the picture shows the sheet. */
function makeRough(drawing, out) {
  const recording = `${out}.jsonl`;
  const copy = `${out}.svg`;
  const events = [
    { resize: [picturePx, picturePx] },
    { action: "grid" },
    { open: `${out.slice(folder.length + 1)}.svg` },
    { action: "zoom_fit" },
  ];
  copyFileSync(drawing, copy);
  writeFileSync(recording, events.map((event) => `${JSON.stringify(event)}\n`).join(""));
  inkflate("replay", recording, "-o", `${out}.inkflate`, "--picture", `${out}.png`);
  rmSync(recording);
  rmSync(copy);
}

/** Every group of strokes is a part already, and the picture shows the model. */
function makeFinished(drawing, out) {
  inkflate("simplify", drawing, "-o", `${out}.inkflate`, "--parts", "groups");
  const look = ["--size", String(picturePx), "--turn", String(turnDegrees), "--shadow"];
  inkflate("render", `${out}.inkflate`, "-o", `${out}.png`, ...look);
}

const examples = JSON.parse(
  readFileSync(new URL("../src/files/examples.json", import.meta.url), "utf8"),
);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
for (const { name, folder: from, isRough } of examples) {
  const drawing = join(top, "examples", from, `${name}.svg`);
  if (isRough) makeRough(drawing, join(folder, `${name}-rough`));
  else makeFinished(drawing, join(folder, name));
}
