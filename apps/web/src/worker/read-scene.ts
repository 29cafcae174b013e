// SPDX-License-Identifier: Apache-2.0
import type {
  AffineNumbers,
  ChunkUpdate,
  ModelMesh,
  ModelUpdate,
  Rgba,
  SceneUpdate,
} from "../protocol/scene";
import type { Answer, BlobPlace } from "./answer";

type ChunkRow =
  readonly [id: number, space: number] | readonly [id: number, space: number, ...list: BlobPlace];

interface MeshHead {
  readonly positions: BlobPlace;
  readonly normals: BlobPlace;
  readonly places: BlobPlace;
  readonly layers: BlobPlace;
  readonly layerCount: number;
  readonly textureWidth: number;
  readonly textureHeight: number;
  readonly texture: BlobPlace;
}

type ModelHead = Omit<ModelUpdate, "mesh"> & { readonly mesh: MeshHead | null };

export interface SceneHead {
  readonly width: number;
  readonly height: number;
  readonly canvasToScreen: AffineNumbers;
  readonly paper: Rgba;
  readonly chunks: readonly ChunkRow[];
  readonly model: ModelHead | null;
}

function readChunk(row: ChunkRow, answer: Answer<SceneHead>): ChunkUpdate {
  const [id, space, start, bytes] = row;
  return {
    id,
    space: space === 0 ? "canvas" : "screen",
    list: start === undefined || bytes === undefined ? null : answer.bytes([start, bytes]),
  };
}

function readMesh(mesh: MeshHead, answer: Answer<SceneHead>): ModelMesh {
  return {
    positions: answer.floats(mesh.positions),
    normals: answer.floats(mesh.normals),
    places: answer.floats(mesh.places),
    layers: answer.floats(mesh.layers),
    layerCount: mesh.layerCount,
    textureWidth: mesh.textureWidth,
    textureHeight: mesh.textureHeight,
    texture: answer.bytes(mesh.texture),
  };
}

/** The scene of an answer. All its arrays share one buffer, so it can be handed on without a copy. */
export function readScene(answer: Answer<SceneHead>): SceneUpdate {
  const { chunks, model, ...rest } = answer.head;
  return {
    ...rest,
    chunks: chunks.map((row) => readChunk(row, answer)),
    model: model && { ...model, mesh: model.mesh && readMesh(model.mesh, answer) },
  };
}
