// SPDX-License-Identifier: Apache-2.0
import { effect } from "@preact/signals";
import { Stage } from "./canvas/stage";
import { ModelView } from "./model/model-view";
import type { SceneUpdate } from "./protocol/scene";
import { isApple } from "./studio/chords";
import { drawingName } from "./studio/drawing-name";
import { markedAs } from "./studio/mark-side";
import type { Studio } from "./studio/studio";

/** The canvas of the model lies over the paper, and lets pointers through to it. */
function openModelView(host: HTMLElement, studio: Studio): ModelView | null {
  const canvas = document.createElement("canvas");
  canvas.className = "model";
  host.append(canvas);
  const opened = ModelView.open(canvas);
  if (opened.ok) return opened.value;
  studio.notify("problem", studio.word("no_webgl"));
  return null;
}

function followMotion(view: ModelView, signal: AbortSignal): void {
  const query = matchMedia("(prefers-reduced-motion: reduce)");
  const follow = () => {
    view.setReducedMotion(query.matches);
  };
  query.addEventListener("change", follow, { signal });
  follow();
}

/** Puts paper and model into the window and shows what the core sends. Returns how to take them away. */
export function mountCanvas(host: HTMLElement, studio: Studio): () => void {
  const end = new AbortController();
  const stage = new Stage(host, {
    send: (event) => {
      const isMarking = studio.state.peek().mode === "draw" && studio.state.peek().tool === "mark";
      return studio.send(isMarking ? markedAs(studio.markSide.peek(), event) : event);
    },
    state: studio.state.peek(),
    isApple: isApple(navigator.platform),
  });
  let model: ModelView | null = null;
  let size = "";
  const showModel = (scene: SceneUpdate) => {
    // Opened when it is first needed: a context takes time and memory.
    if (scene.model !== null && model === null) {
      model = openModelView(host, studio);
      if (model !== null) followMotion(model, end.signal);
    }
    const ratio = window.devicePixelRatio;
    const wanted = `${scene.width} ${scene.height} ${ratio}`;
    if (model !== null && size !== wanted) model.resize(scene.width, scene.height, ratio);
    if (model !== null) size = wanted;
    model?.show(scene.model);
  };
  const stop = studio.onFrame((frame) => {
    stage.show(frame);
    if (frame.scene !== null) showModel(frame.scene);
  });
  const stopTitle = effect(() => {
    document.title = `${drawingName(studio, studio.state.value.fileName)} - Inkflate`;
  });
  return () => {
    end.abort();
    stop();
    stopTitle();
    stage.dispose();
    model?.dispose();
  };
}
