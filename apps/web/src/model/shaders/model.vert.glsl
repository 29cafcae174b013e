// SPDX-License-Identifier: Apache-2.0
// The model's corners as the viewer sees them, each part as high as it has risen.

uniform mat4 u_to_clip;      // from model px
uniform mat3 u_turn;         // normals of the model to those of the view: y up, z towards the viewer
uniform float u_inflation;   // of the part: 0 flat on the paper, 1 as it is
uniform float u_lift_px;     // in depth alone: flat parts lie upon each other in their order
uniform float u_sheet_px;    // in depth alone: a flat part's front lies upon its back

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_place;

// At the edge of a triangle the middle of a pixel lies outside: what is seen there must come from inside.
centroid out vec3 v_normal;
centroid out vec2 v_place;

void main() {
  gl_Position = u_to_clip * vec4(a_position.xy, u_inflation * a_position.z, 1.0);
  gl_Position.z += u_to_clip[2].z * (u_lift_px + u_sheet_px * a_normal.z);
  v_normal = u_turn * vec3(u_inflation * a_normal.xy, a_normal.z);
  v_place = a_place;
}
