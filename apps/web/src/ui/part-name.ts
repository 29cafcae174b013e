// SPDX-License-Identifier: Apache-2.0
import type { LayerRow } from "../protocol/state";
import type { Studio } from "../studio/studio";

/** What a part is called on the page; those without a name have their number. */
export function partName(studio: Pick<Studio, "word">, part: LayerRow): string {
  return part.name === "" ? studio.word("part_numbered", part.id) : part.name;
}
