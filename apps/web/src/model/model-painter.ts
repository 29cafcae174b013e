// SPDX-License-Identifier: Apache-2.0
import type { ModelMesh, ModelUpdate } from "../protocol/scene";
import { GpuModel } from "./gpu-model";
import { InkPass } from "./ink-pass";
import type { Care } from "./ink-pass";
import type { Pose } from "./pose";
import { ShadowPass } from "./shadow-pass";
import { SurfacePass } from "./surface-pass";

/** All that lives in one WebGL context: gone with it, and made anew from the mesh alone. */
export class ModelPainter {
  private readonly gl: WebGL2RenderingContext;
  private readonly shadow: ShadowPass;
  private readonly surface: SurfacePass;
  /** Made when the first picture needs it. */
  private ink: InkPass | null = null;
  private mesh: ModelMesh | null = null;
  private gpuModel: GpuModel | null = null;
  /** Of the last picture that was costly. */
  private finished: WebGLSync | null = null;

  constructor(gl: WebGL2RenderingContext) {
    this.gl = gl;
    this.shadow = new ShadowPass(gl);
    this.surface = new SurfacePass(gl);
    // All colours are premultiplied.
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    // Of two at the same depth the first stays.
    gl.depthFunc(gl.LESS);
    gl.clearColor(0, 0, 0, 0);
  }

  /** The GPU still works on the last picture, and one with less care would help. */
  get isBehind(): boolean {
    if (!this.finished) return false;
    const gl = this.gl;
    return gl.getSyncParameter(this.finished, gl.SYNC_STATUS) !== gl.SIGNALED;
  }

  /** The mesh in the memory of the GPU; it is sent there once. */
  model(mesh: ModelMesh): GpuModel {
    if (this.gpuModel && this.mesh === mesh) return this.gpuModel;
    this.gpuModel?.dispose();
    this.mesh = mesh;
    this.gpuModel = new GpuModel(this.gl, mesh);
    return this.gpuModel;
  }

  /** ratio: px of the display for one of the view. */
  paint(model: GpuModel, update: ModelUpdate, pose: Pose, ratio: number, care: Care): void {
    const gl = this.gl;
    gl.deleteSync(this.finished);
    this.finished = null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.shadow.draw(update.shadow, pose.size, pose.share);
    this.surface.draw(model, pose, update.shading);
    if (update.shading !== "lines") return;
    this.ink ??= new InkPass(gl);
    this.ink.draw(model, pose, ratio, care);
    this.finished = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  }

  dispose(): void {
    this.gl.deleteSync(this.finished);
    this.gpuModel?.dispose();
    this.ink?.dispose();
    this.surface.dispose();
    this.shadow.dispose();
  }
}
