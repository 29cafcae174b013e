// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef } from "preact/hooks";
import type { LayerRow } from "../protocol/state";
import { useStudio } from "./studio-context";

/** The small picture of a part; its name stands beside it. */
export function PartThumbnail({ part }: { readonly part: LayerRow }) {
  const studio = useStudio();
  const canvas = useRef<HTMLCanvasElement>(null);
  const image = studio.thumbnail(part.id, part.look).value?.image ?? null;

  useEffect(() => {
    if (canvas.current === null || image === null) return;
    canvas.current.width = image.width;
    canvas.current.height = image.height;
    canvas.current.getContext("2d")?.putImageData(image, 0, 0);
  }, [image]);

  return (
    <span class="part-thumbnail" aria-hidden="true">
      <canvas ref={canvas} width={1} height={1} />
    </span>
  );
}
