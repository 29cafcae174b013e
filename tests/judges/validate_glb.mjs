// SPDX-License-Identifier: Apache-2.0
// node validate_glb.mjs FILE...: what Khronos' glTF validator says of each file. Exits 1 unless it has nothing to say.
// Only WebGL 1 wanted sides that are powers of two, and meeting that would cost every other viewer memory.
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

const severities = ["error", "warning", "info", "hint"];

const options = (uri) => ({ uri, maxIssues: 10, ignoredIssues: ["IMAGE_NPOT_DIMENSIONS"] });

async function judge(path) {
  try {
    const report = await validator.validateBytes(new Uint8Array(readFileSync(path)), options(path));
    const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
    const said = `${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints`;
    const { totalVertexCount, totalTriangleCount, materialCount } = report.info ?? {};
    console.log(`${path}: ${said}; ${totalVertexCount} vertices, ${totalTriangleCount} triangles, ${materialCount} materials`);
    for (const m of messages) console.log(`  ${severities[m.severity]} ${m.code} ${m.pointer ?? ""}: ${m.message}`);
    return numErrors + numWarnings + numInfos + numHints === 0;
  } catch (failure) {
    console.log(`${path}: not judged: ${failure}`);
    return false;
  }
}

const paths = process.argv.slice(2);
const verdicts = [];
for (const path of paths) verdicts.push(await judge(path));
process.exit(paths.length > 0 && verdicts.every(Boolean) ? 0 : 1);
