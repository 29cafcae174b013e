// SPDX-License-Identifier: Apache-2.0
import type { ModelMesh } from "../protocol/scene";
import { extentOf } from "./extent";
import type { Extent } from "./extent";
import { isWorn, wornTexture } from "./gpu-texture";
import { partRanges } from "./part-ranges";
import type { PartRange } from "./part-ranges";

/** Locations in model.vert.glsl. */
const attributes = [
  { location: 0, size: 3, key: "positions" },
  { location: 1, size: 3, key: "normals" },
  { location: 2, size: 2, key: "places" },
] as const;

/** A model in the memory of the GPU. */
export class GpuModel {
  readonly extent: Extent;
  readonly partCount: number;
  readonly ranges: readonly PartRange[];
  readonly texture: WebGLTexture;
  readonly isWorn: boolean;
  private readonly gl: WebGL2RenderingContext;
  private readonly corners: WebGLVertexArrayObject;
  private readonly buffers: WebGLBuffer[] = [];
  private readonly cornerCount: number;

  constructor(gl: WebGL2RenderingContext, mesh: ModelMesh) {
    this.gl = gl;
    this.cornerCount = mesh.positions.length / 3;
    this.extent = extentOf(mesh.positions);
    this.partCount = Math.max(mesh.layerCount, 1);
    this.ranges = partRanges(mesh.layers);
    this.isWorn = isWorn(mesh);
    this.texture = wornTexture(gl, mesh);
    this.corners = gl.createVertexArray();
    gl.bindVertexArray(this.corners);
    for (const { location, size, key } of attributes) this.upload(location, size, mesh[key]);
    gl.bindVertexArray(null);
  }

  /** All parts at once. */
  draw(): void {
    this.gl.bindVertexArray(this.corners);
    this.gl.drawArrays(this.gl.TRIANGLES, 0, this.cornerCount);
  }

  /** Part by part; `prepare` sets what differs between them. */
  drawParts(prepare: (part: number) => void): void {
    this.gl.bindVertexArray(this.corners);
    for (const { part, first, count } of this.ranges) {
      prepare(part);
      this.gl.drawArrays(this.gl.TRIANGLES, first, count);
    }
  }

  dispose(): void {
    for (const buffer of this.buffers) this.gl.deleteBuffer(buffer);
    this.gl.deleteVertexArray(this.corners);
    this.gl.deleteTexture(this.texture);
  }

  private upload(location: number, size: number, values: Float32Array): void {
    if (values.length === 0) return;
    const gl = this.gl;
    const buffer = gl.createBuffer();
    this.buffers.push(buffer);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, gl.FLOAT, false, 0, 0);
  }
}
