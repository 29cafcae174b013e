// SPDX-License-Identifier: Apache-2.0
import type { GpuModel } from "./gpu-model";
import type { Pose } from "./pose";
import { Program } from "./program";
import { drawPosed } from "./draw-posed";
import edgesFragment from "./shaders/edges.frag.glsl?raw";
import inkFragment from "./shaders/ink.frag.glsl?raw";
import modelVertex from "./shaders/model.vert.glsl?raw";
import normalsFragment from "./shaders/normals.frag.glsl?raw";
import screenVertex from "./shaders/screen.vert.glsl?raw";
import spansFragment from "./shaders/spans.frag.glsl?raw";
import surfaceNormal from "./shaders/surface-normal.glsl?raw";
import { screenBox } from "./screen-box";
import type { ScreenBox } from "./screen-box";
import { Target } from "./target";

/** src/render/rasterise_model.cpp: half the width of an inked edge and the least step in depth, as shares of the longer side. */
const edgeShare = 0.0019;
const jumpShare = 0.008;
const thinnestEdgePx = 0.6;
/** src/render/palette.h */
const inkColour = [0x22 / 255, 0x24 / 255, 0x2b / 255] as const;
/** A display with small pixels needs no finer samples; and neither has a huge one the memory for them. */
const fineRatio = 1.5;
const mostSamples = 12e6;

/** quick: a quarter of the work, with lines a little rougher. */
export type Care = "fine" | "quick";

/** Inks the model where it ends, steps back behind itself, or folds: src/render/model_edges.cpp, on the GPU. */
export class InkPass {
  private readonly gl: WebGL2RenderingContext;
  private readonly normals: Program;
  private readonly edges: Program;
  private readonly spans: Program;
  private readonly ink: Program;
  private readonly seen: Target;
  private readonly inked: Target;
  private readonly nearness: Target;
  private readonly nothing: WebGLVertexArrayObject;

  constructor(gl: WebGL2RenderingContext) {
    this.gl = gl;
    this.normals = new Program(gl, [modelVertex], [surfaceNormal, normalsFragment]);
    this.edges = new Program(gl, [screenVertex], [edgesFragment]);
    this.spans = new Program(gl, [screenVertex], [spansFragment]);
    this.ink = new Program(gl, [screenVertex], [inkFragment]);
    this.seen = new Target(gl, "colour and depth");
    this.inked = new Target(gl, "share");
    this.nearness = new Target(gl, "share");
    this.nothing = gl.createVertexArray();
  }

  /** Over what the canvas shows. */
  draw(model: GpuModel, pose: Pose, ratio: number, care: Care): void {
    const gl = this.gl;
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    const isFine = care === "fine" && ratio < fineRatio && 4 * width * height <= mostSamples;
    const samples = isFine ? 2 : 1;
    const longer = Math.max(pose.size.width, pose.size.height);
    const radius = Math.max(thinnestEdgePx, edgeShare * longer * ratio) * samples;
    const reach = Math.ceil(radius + 0.5);
    for (const target of [this.seen, this.inked, this.nearness]) {
      target.resize(samples * width, samples * height);
      target.clear();
    }
    const picture = { width: samples * width, height: samples * height };
    const box = screenBox(pose.toClip, model.extent, picture, reach + 2);
    gl.disable(gl.BLEND);
    this.limitTo(box, 1);
    this.drawSeen(model, pose);
    this.findEdges(pose.depthPx, jumpShare * longer);
    this.measure(reach);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    this.limitTo(box, samples);
    gl.enable(gl.BLEND);
    // On the paper the drawing has its own lines.
    const ink = [...inkColour.map((channel) => channel * pose.share), pose.share];
    this.ink.use({
      u_nearness: 0,
      u_reach: reach,
      u_radius: radius,
      u_samples: samples,
      u_ink: ink,
    });
    this.cover(this.nearness.colour);
    gl.disable(gl.SCISSOR_TEST);
  }

  dispose(): void {
    for (const program of [this.normals, this.edges, this.spans, this.ink]) program.dispose();
    for (const target of [this.seen, this.inked, this.nearness]) target.dispose();
    this.gl.deleteVertexArray(this.nothing);
  }

  /** Where nothing of the model is, there is nothing to do. */
  private limitTo(box: ScreenBox, samples: number): void {
    const gl = this.gl;
    const up = (px: number): number => Math.ceil(px / samples);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(
      Math.floor(box.x / samples),
      Math.floor(box.y / samples),
      up(box.width),
      up(box.height),
    );
  }

  private drawSeen(model: GpuModel, pose: Pose): void {
    const gl = this.gl;
    this.seen.begin();
    gl.enable(gl.DEPTH_TEST);
    drawPosed(gl, this.normals, model, pose);
    gl.disable(gl.DEPTH_TEST);
  }

  private findEdges(depthPx: number, jumpPx: number): void {
    const gl = this.gl;
    this.inked.begin();
    this.edges.use({ u_seen: 0, u_depth: 1, u_depth_px: depthPx, u_jump_px: jumpPx });
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.seen.depth);
    gl.activeTexture(gl.TEXTURE0);
    this.cover(this.seen.colour);
  }

  private measure(reach: number): void {
    this.nearness.begin();
    this.spans.use({ u_inked: 0, u_reach: reach });
    this.cover(this.inked.colour);
  }

  /** Runs the program in use for every pixel, with a texture to read. */
  private cover(texture: WebGLTexture): void {
    const gl = this.gl;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
