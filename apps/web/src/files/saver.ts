// SPDX-License-Identifier: Apache-2.0
import type { FileOut, Frame } from "../protocol/messages";
import type { Studio } from "../studio/studio";
import { extensionOf, stemOf } from "./file-types";
import { download, hasSavePicker, pickTarget, reasonOf, writeTo } from "./write-file";

interface Target {
  readonly handle: FileSystemFileHandle;
  /** What the core called the drawing then. */
  readonly drawing: string;
}

/** Another drawing is shown than the one before. */
function isOtherDrawing({ state }: Frame, known: string): boolean {
  if (state === null) return false;
  const isReplaced = state.undo === "new" || state.redo === "new" || state.redo === "open";
  return isReplaced || state.fileName !== known;
}

/** Saves files where the person wants them; the project again and again to the same place, as long as it is the same drawing. */
export class Saver {
  private target: Target | null = null;
  /** Becomes the target when the core has read it. */
  private awaited: Target | null = null;

  constructor(private readonly studio: Studio) {}

  /** A drawing is being opened from this file; null: from elsewhere. */
  opening(handle: FileSystemFileHandle | null): void {
    const isProject = handle !== null && extensionOf(handle.name) === ".inkflate";
    this.target = null;
    this.awaited = isProject ? { handle, drawing: stemOf(handle.name) } : null;
  }

  /** To be told of each frame: a file must never get another drawing than its own. */
  see(frame: Frame): void {
    const { awaited, target } = this;
    if (
      awaited !== null &&
      frame.state?.undo === "open" &&
      frame.state.fileName === awaited.drawing
    ) {
      this.target = awaited;
      this.awaited = null;
    } else if (target !== null && isOtherDrawing(frame, target.drawing)) {
      this.target = null;
    }
  }

  /** The project itself. */
  async saveProject(out: FileOut): Promise<void> {
    if (this.target !== null) return this.write(this.target.handle, out);
    const handle = await this.ask(out, () => void this.saveProject(out));
    if (handle === null) return;
    this.target = { handle, drawing: this.studio.state.peek().fileName };
    await this.write(handle, out);
  }

  /** A copy in another format. */
  async saveCopy(out: FileOut): Promise<void> {
    const handle = await this.ask(out, () => void this.saveCopy(out));
    if (handle !== null) await this.write(handle, out);
  }

  /** Several at once, without asking for each. */
  downloadAll(files: readonly FileOut[]): void {
    for (const out of files) download(out);
    this.tell("file_downloaded", files.map(({ name }) => name).join(", "));
  }

  /** null: nowhere, or it has been downloaded. */
  private async ask(out: FileOut, again: () => void): Promise<FileSystemFileHandle | null> {
    if (!hasSavePicker()) {
      this.downloadAll([out]);
      return null;
    }
    try {
      return await pickTarget(out.name, this.studio.label("save"));
    } catch {
      // The browser only lets a fresh press ask, and making the file may have taken longer than that counts.
      this.studio.notify("warning", this.studio.word("file_ready", out.name), {
        label: this.studio.label("save"),
        run: again,
      });
      return null;
    }
  }

  private async write(handle: FileSystemFileHandle, out: FileOut): Promise<void> {
    try {
      await writeTo(handle, out);
      this.tell("file_saved", handle.name);
    } catch (error) {
      if (this.target?.handle === handle) this.target = null;
      const { studio } = this;
      const why = studio.word(reasonOf(error));
      studio.notify("problem", studio.word("file_not_saved", handle.name, why), {
        label: studio.word("download_instead"),
        run: () => {
          this.downloadAll([out]);
        },
      });
    }
  }

  private tell(what: "file_saved" | "file_downloaded", name: string): void {
    this.studio.notify("status", this.studio.word(what, name));
  }
}

const savers = new WeakMap<Studio, Saver>();

/** The one of this studio. */
export function saverOf(studio: Studio): Saver {
  const known = savers.get(studio);
  if (known !== undefined) return known;
  const made = new Saver(studio);
  savers.set(studio, made);
  return made;
}
