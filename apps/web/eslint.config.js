// SPDX-License-Identifier: Apache-2.0
import js from "@eslint/js";
import { defineConfig } from "eslint/config";
import tseslint from "typescript-eslint";

// An upward import is a fault: each folder knows only those below it (docs/WEB_STUDIO.md).
const floors = [
  ["protocol"],
  ["storage"],
  ["worker", "canvas", "model"],
  ["studio"],
  ["files"],
  ["ui"],
];

// The highest floor has nothing above it.
const floorRules = floors.slice(0, -1).flatMap((folders, floor) =>
  folders.map((folder) => ({
    files: [`src/${folder}/**`],
    rules: {
      "no-restricted-imports": [
        "error",
        {
          patterns: [
            {
              group: [
                ...floors.slice(floor + 1).flat(),
                ...folders.filter((f) => f !== folder),
              ].map((name) => `**/${name}/**`),
              message: "imports only go downwards",
            },
          ],
        },
      ],
    },
  })),
);

const pageGlobals = Object.fromEntries(
  "document navigator performance requestAnimationFrame PerformanceObserver fetch File WebAssembly atob btoa indexedDB caches localStorage"
    .split(" ")
    .map((name) => [name, "readonly"]),
);

export default defineConfig(
  js.configs.recommended,
  tseslint.configs.strictTypeChecked,
  {
    languageOptions: { parserOptions: { projectService: true } },
    rules: {
      "no-restricted-exports": ["error", { restrictDefaultExports: { direct: true } }],
      "no-restricted-syntax": [
        "error",
        {
          selector: "AssignmentExpression[left.property.name=/^(inner|outer)HTML$/]",
          message: "no markup from text",
        },
      ],
      "@typescript-eslint/consistent-type-imports": "error",
      "@typescript-eslint/switch-exhaustiveness-check": "error",
      "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
      "max-lines": ["error", { max: 300, skipBlankLines: true }],
    },
  },
  ...floorRules,
  {
    files: ["*.config.*", "e2e/**", "tools/**"],
    ...tseslint.configs.disableTypeChecked,
    languageOptions: {
      parserOptions: { projectService: false },
      globals: {
        console: "readonly",
        process: "readonly",
        URL: "readonly",
        Buffer: "readonly",
        setTimeout: "readonly",
        clearTimeout: "readonly",
      },
    },
  },
  { files: ["**/*.test.*"], rules: { "@typescript-eslint/no-non-null-assertion": "off" } },
  {
    // Tests hold functions that run in the page.
    files: ["e2e/**"],
    languageOptions: { globals: pageGlobals },
  },
  { files: ["*.config.*"], rules: { "no-restricted-exports": "off" } },
  { ignores: ["dist"] },
);
