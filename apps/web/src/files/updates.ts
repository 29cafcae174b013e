// SPDX-License-Identifier: Apache-2.0
import { effect } from "@preact/signals";
import type { Studio } from "../studio/studio";
import { trustedScriptUrl } from "../studio/trusted-urls";

/** A studio that stays open looks for a new version so often. */
const lookEveryMs = 60 * 60 * 1000;

function offer(studio: Studio, waiting: ServiceWorker): void {
  studio.notify("status", studio.word("update_ready"), {
    label: studio.word("reload"),
    run: () => {
      // Another version may have taken over already, in another tab: then this message changes nothing.
      navigator.serviceWorker.addEventListener("controllerchange", () => {
        location.reload();
      });
      waiting.postMessage("take over");
    },
  });
}

function watch(studio: Studio, registration: ServiceWorkerRegistration): void {
  // Without a controller it is the first one, and there is nothing old.
  const hasOld = () => navigator.serviceWorker.controller !== null;
  if (registration.waiting !== null && hasOld()) offer(studio, registration.waiting);
  registration.addEventListener("updatefound", () => {
    const found = registration.installing;
    found?.addEventListener("statechange", () => {
      if (found.state === "installed" && hasOld()) offer(studio, found);
    });
  });
  setInterval(() => {
    void registration.update().catch(() => undefined);
  }, lookEveryMs);
}

async function register(studio: Studio): Promise<void> {
  try {
    const url = trustedScriptUrl(new URL("sw.js", document.baseURI).href);
    watch(studio, await navigator.serviceWorker.register(url));
  } catch {
    // Then the studio needs the network next time, as any page does.
  }
}

/** Keeps the studio on this device for work without a network, and tells when a new version waits. Nothing reloads by itself. */
export function attachUpdates(studio: Studio): void {
  const isServed = location.protocol === "https:" || location.protocol === "http:";
  const has = navigator as { serviceWorker?: ServiceWorkerContainer };
  if (!isServed || has.serviceWorker === undefined) return;
  // All files of the build are fetched then: what one draws with comes first.
  const stop = effect(() => {
    if (studio.isStarting.value) return;
    // The effect has not returned yet when the core is there already.
    queueMicrotask(() => {
      stop();
    });
    void register(studio);
  });
}
