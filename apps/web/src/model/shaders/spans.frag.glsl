// SPDX-License-Identifier: Apache-2.0
// How near the nearest inked sample of the row is: the first half of a distance transform, which has an exact second half.

uniform sampler2D u_inked;
uniform int u_reach;

// 1 - samples / 255; 0, as beyond the picture: none within reach.
out vec4 nearness;

float ink_at(ivec2 place) { return texelFetch(u_inked, place, 0).r; }

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  int nearest = 255;
  for (int away = 0; away <= u_reach; ++away) {
    if (ink_at(here + ivec2(away, 0)) + ink_at(here - ivec2(away, 0)) > 0.0) {
      nearest = away;
      break;
    }
  }
  nearness = vec4(1.0 - float(nearest) / 255.0);
}
