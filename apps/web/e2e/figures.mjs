// SPDX-License-Identifier: Apache-2.0
// Measures the built studio in a real browser and prints a table; judges nothing.
//
//   node e2e/figures.mjs [FILTER]     FILTER: a piece of a figure's name: load, drawing, bending, inflating, memory
import { bending } from "./figures/bending.mjs";
import { drawing } from "./figures/drawing.mjs";
import { inflating } from "./figures/inflating.mjs";
import { load } from "./figures/load.mjs";
import { memory } from "./figures/memory.mjs";
import { launch } from "./harness/browser.mjs";
import { studioFolder } from "./harness/folders.mjs";
import { serve } from "./harness/static-server.mjs";

const figures = { load, drawing, bending, inflating, memory };
const filter = process.argv[2] ?? "";

const server = await serve(studioFolder);
for (const [name, measure] of Object.entries(figures)) {
  if (!name.includes(filter)) continue;
  const browser = await launch();
  for (const [what, value] of await measure(browser, server.origin)) {
    console.log(`${name}: ${what.padEnd(60)} ${value}`);
  }
  await browser.close();
}
await server.close();
