// SPDX-License-Identifier: Apache-2.0
// src/render/model_edges.cpp: the nearer one of two neighbours is inked where the model ends, steps back behind itself, or where two
// surfaces meet at an angle.

uniform sampler2D u_seen;
uniform highp sampler2D u_depth;
uniform float u_depth_px;  // px of the view from the near to the far end
uniform float u_jump_px;   // steps in depth below this are no edge

out vec4 inked;

// A surface that falls away steeply is no edge: steps may be this many times the slope beside them.
const float kSlopeFactor = 3.0;
// Surfaces meet at an edge where their normals differ by more than about 70 degrees.
const float kSmoothCosine = 0.35;

// What is seen at a sample.
struct Sample {
  bool is_there;
  float depth;  // px of the view, from the near end
  vec2 across;  // of the normal
};

Sample at(ivec2 place) {
  // The border goes on: what leaves the picture does not end there.
  ivec2 inside = clamp(place, ivec2(0), textureSize(u_seen, 0) - 1);
  vec4 seen = texelFetch(u_seen, inside, 0);
  return Sample(seen.a > 0.5, u_depth_px * texelFetch(u_depth, inside, 0).r, 2.0 * seen.xy - 1.0);
}

vec3 normal(Sample s) { return vec3(s.across, sqrt(max(1.0 - dot(s.across, s.across), 0.0))); }

// The change of depth between two neighbours; 0 where one of them is empty.
float slope(Sample a, Sample b) { return a.is_there && b.is_there ? abs(a.depth - b.depth) : 0.0; }

bool is_edge(ivec2 place, Sample here, ivec2 step_to) {
  Sample there = at(place + step_to);
  if (!there.is_there) return true;
  if (here.depth > there.depth) return false;  // the other one is nearer
  float step_px = slope(here, there);
  if (step_px > u_jump_px) {
    float before = slope(at(place - step_to), here);
    float after = slope(there, at(place + 2 * step_to));
    if (step_px > u_jump_px + kSlopeFactor * min(before, after)) return true;
  }
  return dot(normal(here), normal(there)) < kSmoothCosine;
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  Sample here = at(place);
  bool is_inked = here.is_there &&
                  (is_edge(place, here, ivec2(1, 0)) || is_edge(place, here, ivec2(-1, 0)) ||
                   is_edge(place, here, ivec2(0, 1)) || is_edge(place, here, ivec2(0, -1)));
  inked = vec4(is_inked ? 1.0 : 0.0);
}
