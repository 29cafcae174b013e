// SPDX-License-Identifier: Apache-2.0
// What the build adds to what Vite makes: the content security policy in the page, and the list of files that the
// service worker keeps.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin, Rollup } from "vite";
import policy from "./content-policy.json";

/** Puts the policy into the built page. The page of the development server is changed by scripts, which it would forbid. */
export function contentPolicy(): Plugin {
  const content = Object.entries(policy)
    .map(([name, value]) => `${name} ${value}`)
    .join("; ");
  return {
    name: "inkflate-content-policy",
    apply: "build",
    transformIndexHtml: () => [
      {
        tag: "meta",
        attrs: { "http-equiv": "Content-Security-Policy", content },
        injectTo: "head-prepend",
      },
    ],
  };
}

/**
 * Lets the browser fetch the core while it still reads the studio's script. The attributes are those of the script's own request:
 * otherwise it would be fetched twice.
 */
export function preloadCore(): Plugin {
  return {
    name: "inkflate-preload-core",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler: (_page, { bundle = {} }) =>
        Object.keys(bundle)
          .filter((name) => name.endsWith(".wasm"))
          .map((name) => ({
            tag: "link",
            attrs: { rel: "preload", as: "fetch", crossorigin: true, href: `./${name}` },
            injectTo: "head",
          })),
    },
  };
}

/** Stands in src/service-worker.ts where the list comes. */
const placeholder = "__INKFLATE_FILES__";

function integrityOf(bytes: Uint8Array | string): string {
  return `sha256-${createHash("sha256").update(bytes).digest("base64")}`;
}

/** Paths of all files below a folder, from there on. */
function filesBelow(folder: string, start = ""): string[] {
  return readdirSync(join(folder, start), { withFileTypes: true }).flatMap((entry) => {
    const path = `${start}${entry.name}`;
    return entry.isDirectory() ? filesBelow(folder, `${path}/`) : [path];
  });
}

function publicFiles(folder: string): [string, string][] {
  return filesBelow(folder).map((path) => [path, integrityOf(readFileSync(join(folder, path)))]);
}

function bundledFiles(bundle: Rollup.OutputBundle, workerName: string): [string, string][] {
  return Object.values(bundle)
    .filter((file) => file.fileName !== workerName)
    .map((file) => [
      // The page is asked for by its folder: a server may send its own name on to that.
      file.fileName === "index.html" ? "./" : file.fileName,
      integrityOf(file.type === "chunk" ? file.code : file.source),
    ]);
}

/** Gives the service worker the names and hashes of all files of the build, and a version made of them. */
export function serviceWorkerFiles(workerName: string): Plugin {
  let publicFolder = "";
  return {
    name: "inkflate-service-worker-files",
    apply: "build",
    configResolved(config) {
      publicFolder = config.publicDir;
    },
    generateBundle: {
      order: "post",
      handler(_options, bundle) {
        const worker = bundle[workerName];
        if (worker?.type !== "chunk") return this.error(`no ${workerName} in the build`);
        // Not every browser takes modules as service workers.
        if (worker.imports.length > 0) return this.error(`${workerName} must import nothing`);
        const files = [...publicFiles(publicFolder), ...bundledFiles(bundle, workerName)].sort(
          ([a], [b]) => (a < b ? -1 : 1),
        );
        const version = createHash("sha256")
          .update(JSON.stringify(files))
          .update(worker.code)
          .digest("hex")
          .slice(0, 12);
        const list = JSON.stringify({ version, files });
        if (!worker.code.includes(placeholder)) return this.error(`no ${placeholder}`);
        worker.code = worker.code.replace(placeholder, () => list);
      },
    },
  };
}
