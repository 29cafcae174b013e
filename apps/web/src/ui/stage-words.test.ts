// SPDX-License-Identifier: Apache-2.0
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { stageWord } from "./stage-words";

const core = fileURLToPath(new URL("../../../../src", import.meta.url));
const sources = readdirSync(core, { recursive: true, encoding: "utf8" })
  .filter((path) => path.endsWith(".cpp"))
  .map((path) => readFileSync(join(core, path), "utf8"));
const stages = sources.flatMap((source) =>
  [...source.matchAll(/progress_?\.enter\("([^"]+)"\)/g)].map((match) => match[1] ?? ""),
);

describe("the stages of long work", () => {
  it("are found in the core", () => {
    expect(stages.length).toBeGreaterThan(20);
  });

  it.each([...new Set(stages)])("has words for the core's stage '%s'", (stage) => {
    expect(stageWord(stage)).not.toBe("stage_other");
  });

  it("has words for a stage that it does not know", () => {
    expect(stageWord("no such stage")).toBe("stage_other");
  });
});
