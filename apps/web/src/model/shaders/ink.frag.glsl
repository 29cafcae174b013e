// SPDX-License-Identifier: Apache-2.0
// A pen as wide as it should be, drawn along all inked samples.

uniform sampler2D u_across;
uniform int u_reach;
uniform float u_radius;       // samples: half the width of the line
uniform int u_samples;        // of a pixel, in a row
uniform vec4 u_ink;           // premultiplied

out vec4 colour;

float across(ivec2 place) {
  return 255.0 * texelFetch(u_across, clamp(place, ivec2(0), textureSize(u_across, 0) - 1), 0).r;
}

float coverage(ivec2 sample_at) {
  float nearest = 1e9;
  for (int step_by = -u_reach; step_by <= u_reach; ++step_by) {
    float x = across(sample_at + ivec2(0, step_by));
    nearest = min(nearest, x * x + float(step_by * step_by));
  }
  return clamp(u_radius + 0.5 - sqrt(nearest), 0.0, 1.0);
}

void main() {
  ivec2 corner = u_samples * ivec2(gl_FragCoord.xy);
  float sum = 0.0;
  for (int y = 0; y < u_samples; ++y) {
    for (int x = 0; x < u_samples; ++x) sum += coverage(corner + ivec2(x, y));
  }
  colour = u_ink * (sum / float(u_samples * u_samples));
}
