// SPDX-License-Identifier: Apache-2.0
import type { Studio } from "../studio/studio";
import type { Word } from "../studio/words";
import list from "./examples.json";
import { openFile } from "./incoming";

export interface Example {
  readonly id: string;
  readonly name: Word;
  /** Loose strokes, still to be simplified. */
  readonly isRough: boolean;
  /** Address of a small picture. */
  readonly picture: string;
  readonly project: string;
}

/** Made by tools/make-gallery.mjs. */
const made = import.meta.glob<string>("../../../../build/gallery/*", {
  query: "?url",
  import: "default",
  eager: true,
});

function addressOf(file: string): string {
  return made[`../../../../build/gallery/${file}`] ?? "";
}

/** Drawings of our own to begin with. Their files are fetched when they are shown or opened. */
export const examples: readonly Example[] = list.map(({ name, isRough }) => {
  const id = isRough ? `${name}-rough` : name;
  return {
    id,
    name: `example_${name}` as Word,
    isRough,
    picture: addressOf(`${id}.png`),
    project: addressOf(`${id}.inkflate`),
  };
});

/** Opens an example as any file is opened: undo brings back what was there. */
export async function openExample(studio: Studio, example: Example): Promise<void> {
  try {
    const response = await fetch(example.project);
    if (!response.ok) throw new Error(response.statusText);
    const name = `${studio.word(example.name)}.inkflate`;
    openFile(studio, new File([await response.blob()], name), "open");
  } catch {
    studio.notify("problem", studio.word("example_failed"), {
      label: studio.word("try_again"),
      run: () => void openExample(studio, example),
    });
  }
}

/** Those that the empty paper offers: rough ones, so that the first key pressed is the one that closes them. */
export function startExamples(
  studio: Studio,
): readonly { readonly name: string; readonly picture: string; readonly open: () => void }[] {
  return examples
    .filter(({ isRough }) => isRough)
    .map((example) => ({
      name: studio.word(example.name),
      picture: example.picture,
      open: () => void openExample(studio, example),
    }));
}
