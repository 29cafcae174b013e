// SPDX-License-Identifier: Apache-2.0
import type { ModelMesh } from "../protocol/scene";

/** The core leaves 8 texels around each rectangle of a texture: smaller copies than an eighth would mix neighbours. */
const smallestLevel = 3;
const mostAnisotropy = 8;

interface Pixels {
  readonly width: number;
  readonly height: number;
  /** RGBA */
  readonly bytes: Uint8Array;
}

const white: Pixels = { width: 1, height: 1, bytes: new Uint8Array([255, 255, 255, 255]) };

/** Every n-th pixel, so that a picture which is too large for this machine is at least shown. */
function thinned(picture: Pixels, longest: number): Pixels {
  const step = Math.ceil(Math.max(picture.width, picture.height) / longest);
  if (step <= 1) return picture;
  const width = Math.floor(picture.width / step);
  const height = Math.floor(picture.height / step);
  const source = new Uint32Array(picture.bytes.slice().buffer);
  const target = new Uint32Array(width * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      target[y * width + x] = source[y * step * picture.width + x * step] ?? 0;
    }
  }
  return { width, height, bytes: new Uint8Array(target.buffer) };
}

function sampleSmoothly(gl: WebGL2RenderingContext): void {
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAX_LEVEL, smallestLevel);
  const anisotropic = gl.getExtension("EXT_texture_filter_anisotropic");
  if (!anisotropic) return;
  const most = Number(gl.getParameter(anisotropic.MAX_TEXTURE_MAX_ANISOTROPY_EXT) ?? 1);
  const anisotropy = Math.min(most, mostAnisotropy);
  gl.texParameterf(gl.TEXTURE_2D, anisotropic.TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
}

/** null: the model wears nothing. */
function picture(mesh: ModelMesh): Pixels | null {
  const { textureWidth: width, textureHeight: height, texture: bytes, places } = mesh;
  const isWhole = bytes.length >= 4 * width * height && width * height > 0 && places.length > 0;
  return isWhole ? { width, height, bytes } : null;
}

export function isWorn(mesh: ModelMesh): boolean {
  return picture(mesh) !== null;
}

/**
 * What the model wears; a white dot where it wears nothing. Colours stay as they are: alpha counts as opaque, as the core has it, so
 * nothing is multiplied by it.
 */
export function wornTexture(gl: WebGL2RenderingContext, mesh: ModelMesh): WebGLTexture {
  const longest = Number(gl.getParameter(gl.MAX_TEXTURE_SIZE) ?? 2048);
  const { width, height, bytes } = thinned(picture(mesh) ?? white, longest);
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  const { RGBA, UNSIGNED_BYTE, TEXTURE_2D } = gl;
  gl.texImage2D(TEXTURE_2D, 0, RGBA, width, height, 0, RGBA, UNSIGNED_BYTE, bytes);
  sampleSmoothly(gl);
  gl.generateMipmap(TEXTURE_2D);
  return texture;
}
