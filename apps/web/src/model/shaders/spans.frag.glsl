// SPDX-License-Identifier: Apache-2.0
// How far the nearest inked sample of the row is, in samples: the first half of a distance transform, which has an exact second half.

uniform sampler2D u_inked;
uniform int u_reach;

out vec4 distance_across;

float at(ivec2 place) {
  return texelFetch(u_inked, clamp(place, ivec2(0), textureSize(u_inked, 0) - 1), 0).r;
}

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  int nearest = 255;
  for (int step_by = 0; step_by <= u_reach; ++step_by) {
    if (at(here + ivec2(step_by, 0)) + at(here - ivec2(step_by, 0)) > 0.0) {
      nearest = step_by;
      break;
    }
  }
  distance_across = vec4(float(nearest) / 255.0);
}
