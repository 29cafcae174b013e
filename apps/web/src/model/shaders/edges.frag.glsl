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

// The border goes on: what leaves the picture does not end there.
ivec2 inside(ivec2 place) { return clamp(place, ivec2(0), textureSize(u_seen, 0) - 1); }

bool is_there(ivec2 place) { return texelFetch(u_seen, inside(place), 0).a > 0.5; }

float depth(ivec2 place) { return u_depth_px * texelFetch(u_depth, inside(place), 0).r; }

vec3 normal(ivec2 place) {
  vec2 across = 2.0 * texelFetch(u_seen, inside(place), 0).xy - 1.0;
  return vec3(across, sqrt(max(1.0 - dot(across, across), 0.0)));
}

// The change of depth between two neighbours; 0 where one of them is empty.
float slope(ivec2 a, ivec2 b) { return is_there(a) && is_there(b) ? abs(depth(a) - depth(b)) : 0.0; }

bool is_edge(ivec2 here, ivec2 step_to) {
  ivec2 there = here + step_to;
  if (!is_there(there)) return true;
  if (depth(here) > depth(there)) return false;  // the other one is nearer
  float step_px = slope(here, there);
  if (step_px > u_jump_px) {
    float beside = min(slope(here - step_to, here), slope(there, there + step_to));
    if (step_px > u_jump_px + kSlopeFactor * beside) return true;
  }
  return dot(normal(here), normal(there)) < kSmoothCosine;
}

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  bool is_inked = is_there(here) &&
                  (is_edge(here, ivec2(1, 0)) || is_edge(here, ivec2(-1, 0)) ||
                   is_edge(here, ivec2(0, 1)) || is_edge(here, ivec2(0, -1)));
  inked = vec4(is_inked ? 1.0 : 0.0);
}
