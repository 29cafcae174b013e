// SPDX-License-Identifier: Apache-2.0
import type { Shading } from "../protocol/state";
import { drawPosed } from "./draw-posed";
import type { GpuModel } from "./gpu-model";
import type { Pose } from "./pose";
import { Program } from "./program";
import modelLight from "./shaders/model-light.glsl?raw";
import modelVertex from "./shaders/model.vert.glsl?raw";
import surfaceFragment from "./shaders/surface.frag.glsl?raw";
import surfaceNormal from "./shaders/surface-normal.glsl?raw";

/** The model in its look, with hidden surfaces removed. */
export class SurfacePass {
  private readonly gl: WebGL2RenderingContext;
  private readonly program: Program;

  constructor(gl: WebGL2RenderingContext) {
    this.gl = gl;
    this.program = new Program(gl, [modelVertex], [surfaceNormal, modelLight, surfaceFragment]);
  }

  draw(model: GpuModel, pose: Pose, shading: Shading): void {
    const gl = this.gl;
    // On the paper it is the drawing, whatever it is going to be.
    const worn = shading === "textured" ? 1 : 1 - pose.share;
    this.program.use({
      u_drawing: 0,
      u_worn: model.isWorn ? worn : 0,
      u_is_paper: shading === "lines" ? 1 : 0,
    });
    gl.bindTexture(gl.TEXTURE_2D, model.texture);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    drawPosed(gl, this.program, model, pose);
    gl.disable(gl.DEPTH_TEST);
  }

  dispose(): void {
    this.program.dispose();
  }
}
