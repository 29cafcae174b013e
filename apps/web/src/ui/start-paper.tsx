// SPDX-License-Identifier: Apache-2.0
import "../styles/start-paper.css";
import { useStudio } from "./studio-context";
import { drawThrough } from "./draw-through";
import { useCanvasPress } from "./use-canvas-press";

export interface StartExample {
  readonly name: string;
  /** Address of its picture. */
  readonly picture: string;
  readonly open: () => void;
}

/** The empty paper: one line of pale ink, which one can draw right across, and a few drawings to begin with. */
export function StartPaper({ examples }: { readonly examples: readonly StartExample[] }) {
  const studio = useStudio();
  const isPressed = useCanvasPress();
  const { isBlank, mode } = studio.state.value;
  // They would take the line from the core, which one draws with.
  const arePicturesDue = !studio.isStarting.value;
  if (!isBlank || mode !== "draw") return null;
  return (
    <div class="start-paper" data-away={isPressed}>
      <p class="start-line">{studio.word("draw_something")}</p>
      {examples.length > 0 && (
        <ul class="start-examples" aria-label={studio.word("examples_to_start")}>
          {examples.map(({ name, picture, open }) => (
            <li key={name}>
              <button
                type="button"
                class="start-example"
                onPointerDown={drawThrough}
                onClick={open}
              >
                <img src={arePicturesDue ? picture : undefined} alt="" draggable={false} />
                <span>{name}</span>
              </button>
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}
