// SPDX-License-Identifier: Apache-2.0
// Pixels of a picture of the page, as Chromium writes it: 8 bits, RGB or RGBA, not interlaced.
import { inflateSync } from "node:zlib";

function paeth(left, up, corner) {
  const guess = left + up - corner;
  const [a, b, c] = [left, up, corner].map((value) => Math.abs(guess - value));
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

const predictors = [() => 0, (left) => left, (_, up) => up, (left, up) => (left + up) >> 1, paeth];

function unfilter(rows, width, height, channels) {
  const stride = width * channels;
  const pixels = new Uint8Array(stride * height);
  for (let y = 0; y < height; ++y) {
    const predict = predictors[rows[y * (stride + 1)]];
    for (let k = 0; k < stride; ++k) {
      const at = y * stride + k;
      const left = k < channels ? 0 : pixels[at - channels];
      const up = y === 0 ? 0 : pixels[at - stride];
      const corner = k < channels || y === 0 ? 0 : pixels[at - stride - channels];
      pixels[at] = rows[y * (stride + 1) + 1 + k] + predict(left, up, corner);
    }
  }
  return pixels;
}

/** @param {Buffer} png */
export function readPng(png) {
  const [width, height, channels] = [
    png.readUInt32BE(16),
    png.readUInt32BE(20),
    png[25] === 6 ? 4 : 3,
  ];
  const data = [];
  for (let at = 8; at < png.length;) {
    const length = png.readUInt32BE(at);
    if (png.toString("latin1", at + 4, at + 8) === "IDAT")
      data.push(png.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  const pixels = unfilter(inflateSync(Buffer.concat(data)), width, height, channels);
  return {
    width,
    height,
    at: (x, y) => {
      const start = (Math.round(y) * width + Math.round(x)) * channels;
      return [...pixels.subarray(start, start + 3)];
    },
  };
}

/** How many pixels differ by more than a little. */
export function countDifferent(one, other) {
  let count = 0;
  for (let y = 0; y < one.height; ++y) {
    for (let x = 0; x < one.width; ++x) {
      const b = other.at(x, y);
      if (one.at(x, y).some((value, channel) => Math.abs(value - b[channel]) > 12)) ++count;
    }
  }
  return count;
}
