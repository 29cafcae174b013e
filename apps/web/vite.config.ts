// SPDX-License-Identifier: Apache-2.0
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { contentPolicy, preloadCore, serviceWorkerFiles } from "./tools/studio-plugins";

const serviceWorker = "sw.js";

/** Where the build of the core puts it: ninja -C build/wasm studio_core. */
const core = fileURLToPath(new URL("../../build/wasm/apps/web", import.meta.url));

// base "./": the studio works from any folder of any static server, a USB stick's too.
export default defineConfig({
  base: "./",
  resolve: {
    alias: [
      { find: /^#core$/, replacement: `${core}/core.js` },
      { find: /^#core\.wasm/, replacement: `${core}/core.wasm` },
    ],
  },
  worker: { format: "es" },
  esbuild: { jsx: "automatic", jsxImportSource: "preact" },
  plugins: [contentPolicy(), preloadCore(), serviceWorkerFiles(serviceWorker)],
  build: {
    outDir: "../../build/studio",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    rollupOptions: {
      input: { studio: "index.html", serviceWorker: "src/service-worker.ts" },
      output: {
        // The service worker's name stays: browsers ask for it again to find a new build.
        entryFileNames: (chunk) =>
          chunk.name === "serviceWorker" ? serviceWorker : "assets/[name]-[hash].js",
      },
    },
  },
  server: { fs: { allow: ["../.."] } },
  test: {
    include: ["src/**/*.test.{ts,tsx}", "tools/**/*.test.mjs"],
    setupFiles: "tools/old-node.mjs",
  },
});
