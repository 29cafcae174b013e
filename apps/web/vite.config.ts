// SPDX-License-Identifier: Apache-2.0
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

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
  build: {
    outDir: "../../build/studio",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
  },
  server: { fs: { allow: ["../.."] } },
  test: { include: ["src/**/*.test.{ts,tsx}"] },
});
