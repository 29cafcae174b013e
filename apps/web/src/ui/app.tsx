// SPDX-License-Identifier: Apache-2.0
import { useEffect } from "preact/hooks";
import type { Studio } from "../studio/studio";
import { CanvasHost, type MountCanvas } from "./canvas-host";
import { ContextBar } from "./context-bar";
import { listenToKeys } from "./keys";
import { Menu } from "./menu";
import { followPreferences } from "./page-look";
import { StudioContext, useStudio } from "./studio-context";
import { ToolBar } from "./tool-bar";
import { Tooltip } from "./tooltip";
import { TopBar } from "./top-bar";
import "../styles/base.css";
import "../styles/shell.css";

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

function Panels() {
  const { panel } = useStudio();
  return panel.value === "menu" ? <Menu /> : null;
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
      </main>
      <div class="chrome">
        <header class="top-bar">
          <TopBar />
        </header>
        <nav class="tools" aria-label={studio.word("tools")}>
          <ToolBar />
        </nav>
        <ContextBar />
      </div>
      <Panels />
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
  useEffect(() => followPreferences(studio.preferences), [studio]);
  return (
    <StudioContext.Provider value={studio}>
      <Shell mount={mount} />
    </StudioContext.Provider>
  );
}
