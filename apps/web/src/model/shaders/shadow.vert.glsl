// SPDX-License-Identifier: Apache-2.0

uniform vec2 u_centre;  // clip space
uniform vec2 u_half;    // half axes, clip space

out vec2 v_place;  // -1 .. 1

void main() {
  v_place = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
  gl_Position = vec4(u_centre + u_half * v_place, 0.0, 1.0);
}
