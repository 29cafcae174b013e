// SPDX-License-Identifier: Apache-2.0
import { existsSync } from "node:fs";
import { expect, test } from "vitest";
import { Artist, coreFolder } from "../worker/artist";
import { emptyState } from "./empty-state";

test.skipIf(!existsSync(new URL("core.wasm", coreFolder)))(
  "the page begins with what the core says of itself",
  async () => {
    const { engine } = await Artist.start();
    const begun = emptyState("en");
    const said = engine.state();
    expect({ ...said, enabled: begun.enabled }).toEqual(begun);
    expect(said.enabled).toEqual(expect.arrayContaining([...begun.enabled]));
  },
);
