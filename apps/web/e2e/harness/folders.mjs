// SPDX-License-Identifier: Apache-2.0
import { fileURLToPath } from "node:url";

const fromHere = (path) => fileURLToPath(new URL(path, import.meta.url));

export const testFolder = fromHere("../");
export const topFolder = fromHere("../../../../");
export const studioFolder = process.env.STUDIO ?? fromHere("../../../../build/studio");
/** A picture of each test, to be looked at; and what is known about those that failed. */
export const pictureFolder = fromHere("../../../../build/e2e/pictures");
export const failureFolder = fromHere("../../../../build/e2e/failures");
