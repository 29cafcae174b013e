// SPDX-License-Identifier: Apache-2.0
import wasmUrl from "#core.wasm?url";
import workerUrl from "../worker/main.ts?worker&url";
import type { FromWorker } from "../protocol/messages";
import type { CorePort } from "./core-client";
import { trustedScriptUrl } from "./trusted-urls";

/** The core in a worker of this browser. */
export function startBrowserWorker(listen: (message: FromWorker) => void): CorePort {
  const worker = new Worker(trustedScriptUrl(workerUrl), { type: "module" });
  worker.onmessage = (event: MessageEvent<FromWorker>) => {
    listen(event.data);
  };
  worker.onerror = (event) => {
    // A worker that could not even be loaded tells no message.
    listen({ kind: "fault", why: event.message || "the worker could not be loaded" });
  };
  return {
    post: (message, transfer = []) => {
      worker.postMessage(message, transfer);
    },
    end: () => {
      worker.terminate();
    },
  };
}

/** Compiles while the bytes come, where the server tells what they are. */
async function compileCore(): Promise<WebAssembly.Module> {
  const answer = await fetch(wasmUrl);
  if (!answer.ok) throw new Error(`the core is not there: ${answer.status}`);
  const isTold = answer.headers.get("Content-Type") === "application/wasm";
  return isTold
    ? WebAssembly.compileStreaming(answer)
    : WebAssembly.compile(await answer.arrayBuffer());
}

let core: Promise<WebAssembly.Module> | null = null;

/** The core, fetched and compiled once however often it is started. */
export function loadBrowserCore(): Promise<WebAssembly.Module> {
  core ??= compileCore();
  // A network that is back is asked again.
  core.catch(() => (core = null));
  return core;
}
