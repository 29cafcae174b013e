// SPDX-License-Identifier: Apache-2.0

const header = "#version 300 es\nprecision highp float;\n";

type UniformValue = number | Float32Array | readonly number[];

/** Vertex and fragment shader, and their uniforms by name. A shader that does not compile is a fault of ours, and throws. */
export class Program {
  private readonly gl: WebGL2RenderingContext;
  private readonly program: WebGLProgram;
  private readonly uniforms = new Map<string, { location: WebGLUniformLocation; type: number }>();

  /** Each shader in pieces, put together in this order. */
  constructor(gl: WebGL2RenderingContext, vertex: readonly string[], fragment: readonly string[]) {
    this.gl = gl;
    this.program = gl.createProgram();
    this.attach(gl.VERTEX_SHADER, vertex);
    this.attach(gl.FRAGMENT_SHADER, fragment);
    gl.linkProgram(this.program);
    // A lost context compiles nothing, and tells so by an event.
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(gl.getProgramInfoLog(this.program) ?? "the shaders do not fit together");
    }
    this.findUniforms();
  }

  use(values: Readonly<Record<string, UniformValue>> = {}): void {
    this.gl.useProgram(this.program);
    for (const [name, value] of Object.entries(values)) this.set(name, value);
  }

  set(name: string, value: UniformValue): void {
    const gl = this.gl;
    const uniform = this.uniforms.get(name);
    if (!uniform) return;
    const { location, type } = uniform;
    if (typeof value === "number") {
      if (type === gl.FLOAT) gl.uniform1f(location, value);
      else gl.uniform1i(location, value);
    } else if (type === gl.FLOAT_VEC2) gl.uniform2fv(location, value);
    else if (type === gl.FLOAT_VEC4) gl.uniform4fv(location, value);
    else if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(location, false, value);
    else gl.uniformMatrix4fv(location, false, value);
  }

  dispose(): void {
    this.gl.deleteProgram(this.program);
  }

  private attach(type: number, pieces: readonly string[]): void {
    const gl = this.gl;
    const shader = gl.createShader(type);
    if (!shader) return; // the context is lost
    gl.shaderSource(shader, header + pieces.join("\n"));
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
      throw new Error(gl.getShaderInfoLog(shader) ?? "the shader does not compile");
    }
    gl.attachShader(this.program, shader);
    gl.deleteShader(shader); // it lives as long as the program
  }

  private findUniforms(): void {
    const gl = this.gl;
    const count = Number(gl.getProgramParameter(this.program, gl.ACTIVE_UNIFORMS) ?? 0);
    for (let i = 0; i < count; ++i) {
      const info = gl.getActiveUniform(this.program, i);
      const location = info && gl.getUniformLocation(this.program, info.name);
      if (info && location) this.uniforms.set(info.name, { location, type: info.type });
    }
  }
}
