// SPDX-License-Identifier: Apache-2.0
import { useSignal } from "@preact/signals";
import type { FileOut } from "../protocol/messages";
import {
  exportFormats,
  sizeText,
  type ExportExtension,
  type ExportFormat,
} from "../files/export-formats";
import { saverOf } from "../files/saver";
import { canShare, share } from "../files/share";
import type { Studio } from "../studio/studio";
import "../styles/export-panel.css";
import { Panel } from "./panel";
import { useStudio } from "./studio-context";
import { useExport, type Making } from "./use-export";

function totalOf(files: readonly FileOut[]): number {
  return files.reduce((sum, file) => sum + file.bytes.byteLength, 0);
}

/** The size once it is known. */
function resultText(studio: Studio, making: Making): string {
  switch (making.kind) {
    case "making":
      return studio.word("export_making");
    case "failed":
      return studio.word("export_failed");
    case "made":
      return sizeText(totalOf(making.files), studio.preferences.language.value);
  }
}

interface RowProps {
  readonly format: ExportFormat;
  readonly making: Making | null;
  readonly onChoose: () => void;
}

function FormatRow({ format, making, onChoose }: RowProps) {
  const studio = useStudio();
  const isChosen = making !== null;
  return (
    <label class="export-format">
      <input
        type="radio"
        name="export-format"
        checked={isChosen}
        data-first-focus={isChosen ? "" : undefined}
        onChange={onChoose}
      />
      <span class="export-name">{studio.word(format.name)}</span>
      <span class="export-holds">{studio.word(format.holds)}</span>
      {isChosen && (
        <span class="export-size" role="status" data-kind={making.kind}>
          {resultText(studio, making)}
        </span>
      )}
    </label>
  );
}

/** A format of several files: each can be saved to a place of its own. */
function FileList({ files }: { readonly files: readonly FileOut[] }) {
  const studio = useStudio();
  const language = studio.preferences.language.value;
  return (
    <ul class="export-files">
      {files.map((file) => (
        <li key={file.name}>
          <span class="export-file-name">{file.name}</span>
          <span class="export-file-size">{sizeText(file.bytes.byteLength, language)}</span>
          <button
            type="button"
            class="export-button"
            aria-label={`${studio.label("save")} ${file.name}`}
            onClick={() => void saverOf(studio).saveCopy(file)}
          >
            {studio.label("save")}
          </button>
        </li>
      ))}
    </ul>
  );
}

function Buttons({ making }: { readonly making: Making }) {
  const studio = useStudio();
  const files = making.kind === "made" ? making.files : [];
  const [first, ...others] = files;
  const save = () => {
    if (first === undefined) return;
    if (others.length > 0) saverOf(studio).downloadAll(files);
    else void saverOf(studio).saveCopy(first);
  };
  const give = () => {
    share(files).catch(() => {
      studio.notify("problem", studio.word("not_shared"));
    });
  };
  return (
    <>
      {canShare(files) && (
        <button type="button" class="export-button" onClick={give}>
          {studio.word("share")}
        </button>
      )}
      <button
        type="button"
        class="export-button export-button-primary"
        disabled={first === undefined}
        onClick={save}
      >
        {others.length > 0 ? studio.word("export_save_all") : studio.label("save")}
      </button>
    </>
  );
}

/** What a drawing with nothing to inflate can become at once. */
function firstChoice(studio: Studio): ExportExtension {
  return studio.state.peek().layers.length > 0 ? "glb" : "svg";
}

/** Takes the drawing or its model away in another format. What it will be is made, and its size shown, before it is saved. */
export function ExportPanel() {
  const studio = useStudio();
  const chosen = useSignal<ExportExtension>(firstChoice(studio));
  const making = useExport(studio, chosen.value);
  const title = studio.label("export");
  const close = () => {
    studio.panel.value = null;
  };
  return (
    <Panel title={title} onClose={close} foot={<Buttons making={making} />}>
      <fieldset class="export-formats">
        <legend class="export-legend">{title}</legend>
        {exportFormats.map((format) => (
          <FormatRow
            key={format.extension}
            format={format}
            making={format.extension === chosen.value ? making : null}
            onChoose={() => {
              chosen.value = format.extension;
            }}
          />
        ))}
      </fieldset>
      {making.kind === "made" && making.files.length > 1 && <FileList files={making.files} />}
    </Panel>
  );
}
