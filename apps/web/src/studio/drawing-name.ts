// SPDX-License-Identifier: Apache-2.0
import type { Studio } from "./studio";

/** What the core calls a drawing until it has a name of its own. */
const given = "drawing";

/** What a drawing is called on the page, in the person's language while it has no name. */
export function drawingName(studio: Pick<Studio, "word">, fileName: string): string {
  return fileName === "" || fileName === given ? studio.word("untitled") : fileName;
}
