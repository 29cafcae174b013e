// SPDX-License-Identifier: Apache-2.0
import { Download, Trash2 } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { download } from "../files/write-file";
import type { SessionRow as Row } from "../protocol/messages";
import { drawingName } from "../studio/drawing-name";
import type { Studio } from "../studio/studio";
import { relativeTime } from "./relative-time";
import { useStudio } from "./studio-context";

/** So long the second press is waited for. */
const confirmMs = 5000;

function useAddress(picture: Uint8Array | null): string | null {
  const [address, setAddress] = useState<string | null>(null);
  useEffect(() => {
    if (picture === null) return undefined;
    const made = URL.createObjectURL(
      new Blob([picture as Uint8Array<ArrayBuffer>], { type: "image/png" }),
    );
    setAddress(made);
    return () => {
      URL.revokeObjectURL(made);
    };
  }, [picture]);
  return picture === null ? null : address;
}

/** The name stands beside it. */
function Picture({ picture }: Pick<Row, "picture">) {
  const address = useAddress(picture);
  return (
    <span class="session-picture" aria-hidden="true">
      {address !== null && <img src={address} alt="" draggable={false} />}
    </span>
  );
}

async function saveRaw(studio: Studio, id: string, name: string): Promise<void> {
  const bytes = await studio.rawSession(id).catch(() => null);
  // The core was started again, and the person was told.
  if (bytes === null) return;
  download({ name: `${name}.journal`, bytes });
  studio.notify("status", studio.word("raw_data_saved", `${name}.journal`));
}

/** What had the focus is going: it moves to the next row, or to the panel. */
function passFocusOn(button: HTMLElement): void {
  const row = button.closest("li");
  const next = row?.nextElementSibling ?? row?.previousElementSibling;
  const heir = next?.querySelector("button") ?? button.closest<HTMLElement>("[role=dialog]");
  heir?.focus();
}

/** A drawing is gone for good with the second press. */
function ForgetButton({ id, name }: { readonly id: string; readonly name: string }) {
  const studio = useStudio();
  const [isAsked, setAsked] = useState(false);

  useEffect(() => {
    if (!isAsked) return undefined;
    const timer = setTimeout(() => {
      setAsked(false);
    }, confirmMs);
    return () => {
      clearTimeout(timer);
    };
  }, [isAsked]);

  const label = studio.word(isAsked ? "forget_drawing_sure" : "forget_drawing", name);
  return (
    <button
      type="button"
      class={isAsked ? "session-sure" : "session-action"}
      aria-label={label}
      title={label}
      onBlur={() => {
        setAsked(false);
      }}
      onClick={(event) => {
        if (!isAsked) {
          // With a press of the mouse the focus stays elsewhere: without it, nothing would take the question back.
          event.currentTarget.focus();
          setAsked(true);
          return;
        }
        passFocusOn(event.currentTarget);
        studio.forgetSession(id);
        studio.notify("status", studio.word("drawing_forgotten", name));
      }}
    >
      <Trash2 size={16} aria-hidden="true" />
      {isAsked && <span>{studio.word("forget_sure")}</span>}
    </button>
  );
}

/** One earlier drawing: picture and name open it. */
export function SessionRow({ session }: { readonly session: Row }) {
  const studio = useStudio();
  const { id, picture, changedMs } = session;
  const name = drawingName(studio, session.name);
  const language = studio.preferences.language.value;
  const rawLabel = studio.word("save_raw_data", name);
  return (
    <li class="session-row">
      <button
        type="button"
        class="session-open"
        onClick={() => {
          studio.openSession(id);
        }}
      >
        <Picture picture={picture} />
        <span class="session-text">
          <span class="session-name">{name}</span>
          {changedMs > 0 && (
            <span class="session-when">{relativeTime(changedMs, Date.now(), language)}</span>
          )}
        </span>
      </button>
      <button
        type="button"
        class="session-action"
        aria-label={rawLabel}
        title={rawLabel}
        onClick={() => void saveRaw(studio, id, name)}
      >
        <Download size={16} aria-hidden="true" />
      </button>
      <ForgetButton id={id} name={name} />
    </li>
  );
}
