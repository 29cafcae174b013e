// SPDX-License-Identifier: Apache-2.0
import type { LayerRow } from "../protocol/state";
import type { Studio } from "../studio/studio";

/** Names that the core gives by itself. */
const given = /^part (\d+)$/;

/** What a part is called on the page; those that nobody has named have a number, in the person's language. */
export function partName(studio: Pick<Studio, "word">, part: LayerRow): string {
  if (part.name === "") return studio.word("part_numbered", part.id);
  const number = given.exec(part.name)?.[1];
  return number === undefined ? part.name : studio.word("part_numbered", number);
}
