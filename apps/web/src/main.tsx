// SPDX-License-Identifier: Apache-2.0
import { render } from "preact";
import { windowView } from "./canvas/window-view";
import { attachFiles } from "./files/attach-files";
import { attachUpdates } from "./files/updates";
import { mountCanvas } from "./mount-canvas";
import { loadBrowserCore, startBrowserWorker } from "./studio/browser-worker";
import { createStudio } from "./studio/create-studio";
import { loadPreferences } from "./studio/preferences";
import { App } from "./ui/app";

const studio = createStudio({
  preferences: loadPreferences(),
  startWorker: startBrowserWorker,
  loadCore: loadBrowserCore,
  view: windowView,
});
attachFiles(studio);
attachUpdates(studio);

// For tests: what a person sees is asked of the page, the rest of the studio.
if (location.hash === "#test") Object.assign(globalThis, { inkflateStudio: studio });

const root = document.getElementById("studio");
if (root !== null) {
  render(<App studio={studio} mount={(host) => mountCanvas(host, studio)} />, root);
}
