// SPDX-License-Identifier: Apache-2.0
import { Plus } from "lucide-preact";
import { useEffect } from "preact/hooks";
import "../styles/sessions-panel.css";
import { Panel } from "./panel";
import { SessionRow } from "./session-row";
import { useStudio } from "./studio-context";

/** Drawings that earlier visits have left on this device. Nothing here touches the one that is open. */
export function SessionsPanel() {
  const studio = useStudio();
  useEffect(() => {
    studio.refreshSessions();
  }, [studio]);
  const sessions = studio.sessions.value;
  const foot = (
    <button
      type="button"
      class="session-new"
      onClick={() => {
        studio.openSession(null);
      }}
    >
      <Plus size={16} aria-hidden="true" />
      {studio.word("begin_new_drawing")}
    </button>
  );
  return (
    <Panel
      title={studio.word("earlier_drawings")}
      foot={foot}
      onClose={() => {
        studio.panel.value = null;
      }}
    >
      {sessions.length === 0 ? (
        <p class="session-none">{studio.word("no_earlier_drawings")}</p>
      ) : (
        <ul class="session-list">
          {sessions.map((session) => (
            <SessionRow key={session.id} session={session} />
          ))}
        </ul>
      )}
    </Panel>
  );
}
