// SPDX-License-Identifier: Apache-2.0
import { defineConfig } from "vitest/config";

// base "./": the studio works from any folder of any static server, a USB stick's too.
export default defineConfig({
  base: "./",
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
