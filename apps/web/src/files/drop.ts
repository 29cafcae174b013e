// SPDX-License-Identifier: Apache-2.0
import "../styles/drop.css";
import { filesOf } from "./transfer";

function holdsFiles(event: DragEvent): boolean {
  const types = event.dataTransfer?.types ?? [];
  return ["Files", "image/svg+xml"].some((type) => types.includes(type));
}

/** Files may be dropped anywhere on the page. `hint` is shown while they hover. */
export function listenForDrops(
  hint: () => string,
  textName: () => string,
  take: (files: readonly File[]) => void,
  signal: AbortSignal,
): void {
  const root = document.documentElement;
  const hide = () => {
    delete root.dataset["dropHint"];
  };
  const over = (event: DragEvent) => {
    if (!holdsFiles(event)) return;
    // Without it the browser would leave the studio and show the file.
    event.preventDefault();
    if (event.dataTransfer !== null) event.dataTransfer.dropEffect = "copy";
    root.dataset["dropHint"] = hint();
  };
  window.addEventListener("dragenter", over, { signal });
  window.addEventListener("dragover", over, { signal });
  window.addEventListener(
    "dragleave",
    (event) => {
      if (event.relatedTarget === null) hide();
    },
    { signal },
  );
  window.addEventListener(
    "drop",
    (event) => {
      hide();
      if (event.dataTransfer === null || !holdsFiles(event)) return;
      event.preventDefault();
      take(filesOf(event.dataTransfer, textName()));
    },
    { signal },
  );
  signal.addEventListener("abort", hide);
}
