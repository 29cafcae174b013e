// SPDX-License-Identifier: Apache-2.0
declare module "#core.wasm?url" {
  const url: string;
  export { url as default };
}
