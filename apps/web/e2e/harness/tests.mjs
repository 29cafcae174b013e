// SPDX-License-Identifier: Apache-2.0
// Where test files put their tests; run.mjs takes them out again, file by file.

let tests = [];

/**
 * @param {string} title a law, as a sentence
 * @param {object} options device: a name of devices.mjs; context: more for the browser's context; timeoutS; isLong: only with
 *     --long; expects: patterns of faults that the test provokes
 * @param {(world: object) => Promise<void>} body
 */
export function test(title, options, body) {
  tests.push({ title, options, body });
}

export function takeTests() {
  const taken = tests;
  tests = [];
  return taken;
}
