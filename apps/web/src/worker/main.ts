// SPDX-License-Identifier: Apache-2.0
import type { FromWorker, ToWorker } from "../protocol/messages";
import type { CoreWorker } from "./core-worker";
import { startCore } from "./start-core";

declare const self: DedicatedWorkerGlobalScope;

const post = (message: FromWorker, transfer: Transferable[] = []) => {
  self.postMessage(message, transfer);
};

let worker: CoreWorker | null = null;
/** What comes while the core loads. */
const early: ToWorker[] = [];

self.onmessage = (event: MessageEvent<ToWorker>) => {
  const message = event.data;
  if (worker !== null) {
    worker.take(message);
  } else if (message.kind === "start") {
    startCore(message, post).then(
      (started) => {
        worker = started;
        for (const each of early.splice(0)) started.take(each);
      },
      (fault: unknown) => {
        post({ kind: "fault", why: fault instanceof Error ? fault.message : String(fault) });
      },
    );
  } else {
    early.push(message);
  }
};
