// SPDX-License-Identifier: Apache-2.0
import type { ModelUpdate } from "../protocol/scene";
import type { ViewSize } from "./placement";
import { Program } from "./program";
import shadowFragment from "./shaders/shadow.frag.glsl?raw";
import shadowVertex from "./shaders/shadow.vert.glsl?raw";

/** The soft ellipse that the model stands on. */
export class ShadowPass {
  private readonly gl: WebGL2RenderingContext;
  private readonly program: Program;
  private readonly nothing: WebGLVertexArrayObject;

  constructor(gl: WebGL2RenderingContext) {
    this.gl = gl;
    this.program = new Program(gl, [shadowVertex], [shadowFragment]);
    this.nothing = gl.createVertexArray();
  }

  /** strength: 0 .. 1 */
  draw(shadow: ModelUpdate["shadow"], size: ViewSize, strength: number): void {
    const gl = this.gl;
    this.program.use({
      u_centre: [(2 * shadow.x) / size.width - 1, 1 - (2 * shadow.y) / size.height],
      u_half: [(2 * shadow.rx) / size.width, (2 * shadow.ry) / size.height],
      u_strength: strength,
    });
    gl.enable(gl.BLEND);
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  dispose(): void {
    this.program.dispose();
    this.gl.deleteVertexArray(this.nothing);
  }
}
