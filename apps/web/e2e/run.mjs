// SPDX-License-Identifier: Apache-2.0
// Tries the built studio in a real browser.
//
//   node e2e/run.mjs [--long] [FILTER]     FILTER: a piece of a file's name or of a test's title
//
// The last line counts what passed and failed. Leaves a picture of each test in build/e2e/pictures.
import { existsSync } from "node:fs";
import { mkdir, readdir, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { launch } from "./harness/browser.mjs";
import { failureFolder, pictureFolder, studioFolder, testFolder } from "./harness/folders.mjs";
import { serve } from "./harness/static-server.mjs";
import { takeTests } from "./harness/tests.mjs";
import { fileNameOf, visit } from "./harness/visit.mjs";

const usualTimeoutS = 120;

const words = process.argv.slice(2);
const isLong = words.includes("--long");
const filter = words.find((word) => !word.startsWith("--")) ?? "";

async function testFiles() {
  const names = await readdir(testFolder, { recursive: true });
  return names.filter((name) => name.endsWith(".e2e.mjs")).sort();
}

async function testsOf(file) {
  await import(pathToFileURL(join(testFolder, file)));
  const isWanted = ({ title }) => file.includes(filter) || title.includes(filter);
  return takeTests().filter((test) => isWanted(test) && (isLong || !test.options.isLong));
}

function within(seconds, work) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`not done after ${seconds} s`)), seconds * 1000);
  });
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}

/** @returns {Promise<string>} why it failed; "": it has not */
async function why(test, world) {
  try {
    await within(test.options.timeoutS ?? usualTimeoutS, test.body(world));
  } catch (failure) {
    return String(failure.stack ?? failure);
  }
  return world.watch.faults.map(({ kind, text }) => `${kind}: ${text}`).join("\n");
}

async function tell(title, failure) {
  console.log(`${title}: ${failure === "" ? "passed" : "failed"}`);
  if (failure === "") return;
  console.log(failure.split("\n").slice(0, 12).join("\n"));
  await writeFile(join(failureFolder, `${fileNameOf(title)}.txt`), failure);
}

async function run(test, browser, origin) {
  const world = await visit(browser, origin, test.title, test.options);
  const failure = await why(test, world);
  await world.end(failure !== "");
  return { failure, faults: world.watch.faults };
}

/** A browser that has gone down takes one test along, not those after it. */
async function runFile(file, origin) {
  const tests = await testsOf(file);
  if (tests.length > 0) console.log(`\n${file}`);
  const results = [];
  let browser = null;
  for (const test of tests) {
    if (!browser?.isConnected()) browser = await launch();
    const result = await run(test, browser, origin).catch((error) => ({
      failure: String(error.stack),
      faults: [],
    }));
    await tell(test.title, result.failure);
    results.push({ isPassed: result.failure === "", faults: result.faults });
  }
  await browser?.close();
  return results;
}

async function main() {
  if (!existsSync(join(studioFolder, "index.html"))) {
    console.log(`There is no studio in ${studioFolder}; build it first: npm run build`);
    return 2;
  }
  for (const folder of [pictureFolder, failureFolder]) {
    if (filter === "") await rm(folder, { recursive: true, force: true });
    await mkdir(folder, { recursive: true });
  }
  const server = await serve(studioFolder);
  const results = [];
  for (const file of await testFiles()) results.push(...(await runFile(file, server.origin)));
  await server.close();

  const faults = results.flatMap((result) => result.faults);
  const kinds = ["foreign request", "policy breach", "page error", "console error"];
  const counts = kinds.map((kind) => `${kind}s: ${faults.filter((f) => f.kind === kind).length}`);
  console.log(`\n${counts.join(", ").replace("breachs", "breaches")}`);
  const passed = results.filter((result) => result.isPassed).length;
  console.log(`${passed} passed, ${results.length - passed} failed`);
  return passed === results.length ? 0 : 1;
}

process.exitCode = await main();
