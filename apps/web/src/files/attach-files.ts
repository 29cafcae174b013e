// SPDX-License-Identifier: Apache-2.0
import { effect } from "@preact/signals";
import type { FileUse } from "../protocol/events";
import type { FileOut } from "../protocol/messages";
import type { Studio } from "../studio/studio";
import { listenForDrops } from "./drop";
import type { LaunchWindow } from "./file-system-access";
import { Incoming, openFile } from "./incoming";
import { pickFile } from "./pick-file";
import { saverOf, type Saver } from "./saver";
import { filesOf, isTextField } from "./transfer";

/** Everything between the studio and files: dialogs, drops, pastes, files opened from outside, saving. */
class Files {
  private readonly saver: Saver;
  private readonly incoming: Incoming;

  constructor(private readonly studio: Studio) {
    this.saver = saverOf(studio);
    this.incoming = new Incoming(studio);
  }

  attach(signal: AbortSignal): void {
    const { studio } = this;
    studio.onOpen = (use) => void this.ask(use);
    studio.onFiles = (files) => {
      this.save(files);
    };
    const stopSeeing = studio.onFrame((frame) => {
      this.saver.see(frame);
    });
    const stopForgetting = effect(() => {
      if (studio.isStarting.value) this.saver.opening(null);
    });
    signal.addEventListener("abort", () => {
      stopSeeing();
      stopForgetting();
    });
    this.listen(signal);
  }

  private listen(signal: AbortSignal): void {
    const { studio } = this;
    const textName = () => `${studio.word("pasted_drawing")}.svg`;
    const take = (files: readonly File[]) => {
      this.incoming.take(files);
    };
    listenForDrops(() => studio.word("drop_here"), textName, take, signal);
    window.addEventListener(
      "paste",
      (event) => {
        if (event.clipboardData === null || isTextField(event.target)) return;
        const files = filesOf(event.clipboardData, textName());
        if (files.length > 0) event.preventDefault();
        take(files);
      },
      { signal },
    );
    window.addEventListener(
      "beforeunload",
      (event) => {
        const { isBlank, isSaved } = studio.state.peek();
        const isKept = studio.saveState.peek().kind !== "refused";
        if (!isKept && !isBlank && !isSaved) event.preventDefault();
      },
      { signal },
    );
    (window as LaunchWindow).launchQueue?.setConsumer(({ files }) => {
      for (const handle of files.slice(0, 1)) void this.openHandle(handle);
    });
  }

  private async ask(use: FileUse): Promise<void> {
    const { studio } = this;
    try {
      const picked = await pickFile(use, studio.word("drawings_and_pictures"));
      if (picked !== null) openFile(studio, picked.file, use, picked.handle);
    } catch {
      // The browser only lets a fresh press ask.
      studio.notify("warning", studio.word("choose_file"), {
        label: studio.label(use === "template" ? "open_template" : "open"),
        run: () => void this.ask(use),
      });
    }
  }

  /** The system has started the studio with a file. */
  private async openHandle(handle: FileSystemFileHandle): Promise<void> {
    try {
      openFile(this.studio, await handle.getFile(), "open", handle);
    } catch {
      this.studio.notify("problem", this.studio.word("cannot_read_file", handle.name));
    }
  }

  private save(files: readonly FileOut[]): void {
    const [first, ...others] = files;
    if (first === undefined) return;
    if (others.length > 0) this.saver.downloadAll(files);
    else void this.saver.saveProject(first);
  }
}

/** Connects the studio with files. Returns how to let go of them. */
export function attachFiles(studio: Studio): () => void {
  const end = new AbortController();
  new Files(studio).attach(end.signal);
  return () => {
    end.abort();
  };
}
