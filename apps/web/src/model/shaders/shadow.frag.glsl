// SPDX-License-Identifier: Apache-2.0
// src/render/ground_shadow.cpp: black, premultiplied.

uniform float u_strength;  // 0 .. 1

in vec2 v_place;

out vec4 colour;

const float kDarkest = 70.0 / 255.0;

void main() {
  float share = max(1.0 - dot(v_place, v_place), 0.0);
  colour = vec4(0.0, 0.0, 0.0, u_strength * kDarkest * share * share);
}
