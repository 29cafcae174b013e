// SPDX-License-Identifier: Apache-2.0
import "../styles/base.css";
import "../styles/shell.css";
import { useEffect, useLayoutEffect } from "preact/hooks";
import { startExamples } from "../files/examples";
import type { Studio } from "../studio/studio";
import { CanvasHost, type MountCanvas } from "./canvas-host";
import { ContextBar } from "./context-bar";
import { ExportPanel } from "./export-panel";
import { GalleryPanel } from "./gallery-panel";
import { HelpPanel } from "./help-panel";
import { Hints } from "./hints";
import { listenToKeys } from "./keys";
import { LongWorkBar } from "./long-work";
import { Menu } from "./menu";
import { Notices, StatusLine } from "./notices";
import { followPreferences } from "./page-look";
import { PalettePanel } from "./palette-panel";
import { PartsPanel } from "./parts-panel";
import { SessionsPanel } from "./sessions-panel";
import { SettingsPanel } from "./settings-panel";
import { StartPaper } from "./start-paper";
import { StudioContext, useStudio } from "./studio-context";
import { ToolBar } from "./tool-bar";
import { Tooltip } from "./tooltip";
import { TopBar } from "./top-bar";

/**
 * A press on a button leaves the focus where it is: Enter goes on meaning Simplify after a tool has been picked with the mouse. Keys
 * reach buttons by Tab.
 */
function keepFocus(event: MouseEvent): void {
  if (!(event.target instanceof Element) || event.target.closest("button") === null) return;
  event.preventDefault();
  const active = document.activeElement;
  // A name that is being typed is taken over by leaving it.
  if (active instanceof HTMLInputElement) active.blur();
}

/** What lies over the canvas when it is asked for. Parts have a place of their own where the window is wide. */
function OpenPanel() {
  const { panel } = useStudio();
  switch (panel.value) {
    case "menu":
      return <Menu />;
    case "help":
      return <HelpPanel />;
    case "palette":
      return <PalettePanel />;
    case "settings":
      return <SettingsPanel />;
    case "export":
      return <ExportPanel />;
    case "gallery":
      return <GalleryPanel />;
    case "sessions":
      return <SessionsPanel />;
    case "parts":
    case null:
      return null;
  }
}

function Shell({ mount }: { readonly mount: MountCanvas }) {
  const studio = useStudio();
  return (
    <div class="studio" onMouseDown={keepFocus}>
      <a class="skip-link" href="#drawing">
        {studio.word("skip_to_drawing")}
      </a>
      <main id="drawing" tabIndex={-1} aria-label={studio.word("drawing")}>
        <CanvasHost mount={mount} />
        <StartPaper examples={startExamples(studio)} />
      </main>
      <div class="chrome">
        <TopBar />
        <nav class="tools" aria-label={studio.word("tools")}>
          <ToolBar />
        </nav>
        <PartsPanel />
        <ContextBar />
      </div>
      <Hints />
      <LongWorkBar />
      <OpenPanel />
      <Notices />
      <StatusLine />
      <Tooltip />
    </div>
  );
}

interface AppProps {
  readonly studio: Studio;
  readonly mount: MountCanvas;
}

/** The whole page. */
export function App({ studio, mount }: AppProps) {
  useEffect(() => listenToKeys(studio), [studio]);
  // Before the first picture: no flash of the other theme.
  useLayoutEffect(() => followPreferences(studio.preferences), [studio]);
  return (
    <StudioContext.Provider value={studio}>
      <Shell mount={mount} />
    </StudioContext.Provider>
  );
}
