// SPDX-License-Identifier: Apache-2.0
import type { Shading } from "./state";

/** What the window shows: src/editor/scene.h. */

/** Red, green, blue, alpha in four bytes, red in the lowest: as in ImageData on every machine that browsers run on. */
export type Rgba = number;

/** [a, b, c, d, e, f]: x' = a x + c y + e, y' = b x + d y + f, as CanvasRenderingContext2D.setTransform takes them. */
export type AffineNumbers = readonly [number, number, number, number, number, number];

export interface ChunkUpdate {
  /** Another content has another id. */
  readonly id: number;
  readonly space: "canvas" | "screen";
  /** A draw list as draw-list.ts reads it; null: the page has been sent it before. */
  readonly list: Uint8Array | null;
}

/** Triangles with their own corners, ready to be handed to a GPU. */
export interface ModelMesh {
  /** 3 per corner; px: x to the right, y up, z to the viewer. 9 numbers per triangle. */
  readonly positions: Float32Array;
  /** Of length 1; 9 numbers per triangle. */
  readonly normals: Float32Array;
  /** u to the right, v down, 0 .. 1; 6 numbers per triangle. Empty: no texture. */
  readonly places: Float32Array;
  /** Depth order of its layer, 0 at the back; 3 per triangle (the same). */
  readonly layers: Float32Array;
  readonly layerCount: number;
  readonly textureWidth: number;
  readonly textureHeight: number;
  /** RGBA, row by row from the top; empty: no texture. */
  readonly texture: Uint8Array;
}

/** The model over the paper. All of its geometry is in the core: the page multiplies. */
export interface ModelUpdate {
  /** Of mesh and texture. */
  readonly id: number;
  /** null: the page has been sent it before. */
  readonly mesh: ModelMesh | null;
  /** 3 x 4, row by row: from model px to the view's px: origin top left, x right, y down, z towards the viewer. */
  readonly toView: readonly number[];
  /** The same for the model lying flat on the paper where it was drawn: where the change from the drawing begins. */
  readonly onPaper: readonly number[];
  readonly shading: Shading;
  /** Soft ellipse on the ground: centre and half axes in px of the view. */
  readonly shadow: {
    readonly x: number;
    readonly y: number;
    readonly rx: number;
    readonly ry: number;
  };
}

export interface SceneUpdate {
  readonly width: number;
  readonly height: number;
  readonly canvasToScreen: AffineNumbers;
  readonly paper: Rgba;
  /** Back to front. */
  readonly chunks: readonly ChunkUpdate[];
  readonly model: ModelUpdate | null;
}
