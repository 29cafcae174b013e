// SPDX-License-Identifier: Apache-2.0
// src/render/model_light.cpp, colours from 0 to 1.

// Directions to the key light and half way from it to the viewer.
const vec3 kKey = vec3(-0.4558, 0.6077, 0.6503);
const vec3 kHalfWay = vec3(-0.2508, 0.3345, 0.9084);

const vec3 kClay = vec3(232.0, 158.0, 116.0) / 255.0;
const vec3 kClayShade = vec3(128.0, 70.0, 68.0) / 255.0;
const vec3 kClayLit = vec3(255.0, 226.0, 196.0) / 255.0;
const vec3 kShade = vec3(0.70, 0.62, 0.68);
const vec3 kLit = vec3(1.03, 1.02, 1.00);
const vec3 kPaper = vec3(255.0, 253.0, 249.0) / 255.0;
const vec3 kPaperShade = vec3(226.0, 222.0, 220.0) / 255.0;

// How much of the key light arrives; it reaches around the edge a little, as light from a large window does.
float key_light(vec3 normal) { return smoothstep(-0.55, 0.90, dot(normal, kKey)); }

// The share of open sky below a surface that looks down.
float openness(vec3 normal) {
  float down = max(-normal.y, 0.0);
  return 1.0 - 0.22 * down * down;
}

float highlight(vec3 normal) { return pow(max(dot(normal, kHalfWay), 0.0), 16.0); }

float rim(vec3 normal) {
  float away = 1.0 - clamp(normal.z, 0.0, 1.0);
  return away * away * away;
}

// Warm clay under a key light from the upper left, darker below, a pale rim.
vec3 clay_colour(vec3 normal) {
  vec3 body = mix(kClayShade, kClay, key_light(normal));
  vec3 lit = mix(body, kClayLit, 0.45 * highlight(normal));
  float above = 0.35 + 0.65 * clamp(0.5 + normal.y, 0.0, 1.0);
  return openness(normal) * mix(lit, kClayLit, 0.38 * above * rim(normal));
}

// A soft light that leaves colours as they were drawn where they face it.
vec3 softly_lit(vec3 colour, vec3 normal) {
  float gloss = 14.0 * highlight(normal) + 16.0 * rim(normal) * max(normal.y, 0.0);
  return openness(normal) * mix(kShade, kLit, key_light(normal)) * colour + gloss / 255.0;
}

// Paper with one pale tone in the shade. A narrow ramp instead of a step keeps the border of the tone antialiased.
vec3 paper_colour(vec3 normal) {
  return mix(kPaperShade, kPaper, smoothstep(0.02, 0.10, dot(normal, kKey)));
}
