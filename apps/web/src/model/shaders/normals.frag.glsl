// SPDX-License-Identifier: Apache-2.0
// What the edges are found in: the normal, and whether there is anything. The depth has a texture of its own.

centroid in vec3 v_normal;

out vec4 seen;

void main() {
  seen = vec4(0.5 + 0.5 * surface_normal(v_normal, gl_FrontFacing).xy, 0.0, 1.0);
}
