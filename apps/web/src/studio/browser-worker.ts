// SPDX-License-Identifier: Apache-2.0
import type { FromWorker } from "../protocol/messages";
import type { CorePort } from "./core-client";

/** The core in a worker of this browser. */
export function startBrowserWorker(listen: (message: FromWorker) => void): CorePort {
  const worker = new Worker(new URL("../worker/main.ts", import.meta.url), { type: "module" });
  worker.onmessage = (event: MessageEvent<FromWorker>) => {
    listen(event.data);
  };
  worker.onerror = (event) => {
    listen({ kind: "fault", why: event.message });
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
