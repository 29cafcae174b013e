// SPDX-License-Identifier: Apache-2.0

/** A picture that is drawn for the next step to read. */
export class Target {
  readonly colour: WebGLTexture;
  /** null: it has none. */
  readonly depth: WebGLTexture | null;
  private readonly gl: WebGL2RenderingContext;
  private readonly frame: WebGLFramebuffer;
  private readonly kind: "colour and depth" | "share";
  private width = 0;
  private height = 0;

  /** share: one number per pixel, 0 .. 1. */
  constructor(gl: WebGL2RenderingContext, kind: "colour and depth" | "share") {
    this.gl = gl;
    this.kind = kind;
    this.frame = gl.createFramebuffer();
    this.colour = this.texture();
    this.depth = kind === "share" ? null : this.texture();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    this.attach(gl.COLOR_ATTACHMENT0, this.colour);
    if (this.depth) this.attach(gl.DEPTH_ATTACHMENT, this.depth);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  resize(width: number, height: number): void {
    if (width === this.width && height === this.height) return;
    this.width = width;
    this.height = height;
    const gl = this.gl;
    gl.bindTexture(gl.TEXTURE_2D, this.colour);
    const [inside, layout] = this.kind === "share" ? [gl.R8, gl.RED] : [gl.RGBA8, gl.RGBA];
    gl.texImage2D(gl.TEXTURE_2D, 0, inside, width, height, 0, layout, gl.UNSIGNED_BYTE, null);
    if (!this.depth) return;
    gl.bindTexture(gl.TEXTURE_2D, this.depth);
    const { TEXTURE_2D, DEPTH_COMPONENT24, DEPTH_COMPONENT, UNSIGNED_INT } = gl;
    gl.texImage2D(
      TEXTURE_2D,
      0,
      DEPTH_COMPONENT24,
      width,
      height,
      0,
      DEPTH_COMPONENT,
      UNSIGNED_INT,
      null,
    );
  }

  /** What is drawn from now on goes here. */
  begin(): void {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.viewport(0, 0, this.width, this.height);
  }

  clear(): void {
    this.begin();
    this.gl.clear(this.gl.COLOR_BUFFER_BIT | this.gl.DEPTH_BUFFER_BIT);
  }

  dispose(): void {
    this.gl.deleteFramebuffer(this.frame);
    this.gl.deleteTexture(this.colour);
    this.gl.deleteTexture(this.depth);
  }

  private texture(): WebGLTexture {
    const gl = this.gl;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    }
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) {
      gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
    }
    return texture;
  }

  private attach(point: number, texture: WebGLTexture): void {
    const { FRAMEBUFFER, TEXTURE_2D } = this.gl;
    this.gl.framebufferTexture2D(FRAMEBUFFER, point, TEXTURE_2D, texture, 0);
  }
}
