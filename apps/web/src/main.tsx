import { render } from "preact";
import { attachFiles } from "./files/attach-files";
import { attachUpdates } from "./files/updates";
import { startExamples } from "./files/examples";
import { loadBrowserCore, startBrowserWorker } from "./studio/browser-worker";
import { createStudio } from "./studio/create-studio";
import { loadPreferences } from "./studio/preferences";
import { App } from "./ui/app";
import { ExportPanel } from "./ui/export-panel";
import { GalleryPanel } from "./ui/gallery-panel";
import { Notices } from "./ui/notices";
import { StartPaper } from "./ui/start-paper";
import { StudioContext } from "./ui/studio-context";
const studio = createStudio({ preferences: loadPreferences(), startWorker: startBrowserWorker, loadCore: loadBrowserCore });
attachFiles(studio); attachUpdates(studio);
(globalThis as {studio?: unknown}).studio = studio;
function Root() {
  const close = () => { studio.panel.value = null; };
  return <><App studio={studio} mount={() => () => undefined} /><StudioContext.Provider value={studio}>
    <StartPaper examples={startExamples(studio)} /><Notices />
    {studio.panel.value === "export" && <ExportPanel onClose={close} />}
    {studio.panel.value === "gallery" && <GalleryPanel onClose={close} />}
  </StudioContext.Provider></>;
}
const root = document.getElementById("studio"); if (root) render(<Root />, root);
