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

let bytes: Promise<ArrayBuffer> | null = null;

/** The core's bytes, fetched once however often it is started. */
export function loadBrowserCore(): Promise<ArrayBuffer> {
  bytes ??= fetch(wasmUrl).then((answer) => {
    if (!answer.ok) throw new Error(`the core is not there: ${answer.status}`);
    return answer.arrayBuffer();
  });
  // A network that is back is asked again.
  bytes.catch(() => (bytes = null));
  return bytes;
}
