// SPDX-License-Identifier: Apache-2.0
// A pen as wide as it should be, drawn along all inked samples.

uniform sampler2D u_nearness;  // of ink in the row
uniform int u_reach;
uniform float u_radius;        // samples: half the width of the line
uniform int u_samples;         // of a pixel, in a row: 1 or 2
uniform vec4 u_ink;            // premultiplied

out vec4 colour;

// How much of two samples, one above the other, the pen covers.
vec2 coverage(ivec2 lower) {
  vec2 nearest = vec2(1e9);
  for (int away = -u_reach; away <= u_reach + 1; ++away) {
    float across = 255.0 - 255.0 * texelFetch(u_nearness, lower + ivec2(0, away), 0).r;
    vec2 along = float(away) - vec2(0.0, 1.0);
    nearest = min(nearest, across * across + along * along);
  }
  return clamp(u_radius + 0.5 - sqrt(nearest), 0.0, 1.0);
}

void main() {
  ivec2 place = u_samples * ivec2(gl_FragCoord.xy);
  vec2 covered = coverage(place);
  float share = covered.x;
  if (u_samples == 2) {
    vec2 beside = coverage(place + ivec2(1, 0));
    share = dot(covered + beside, vec2(0.25));
  }
  colour = u_ink * share;
}
