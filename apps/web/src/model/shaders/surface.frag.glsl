// SPDX-License-Identifier: Apache-2.0

uniform sampler2D u_drawing;
uniform float u_worn;       // how much of the drawing the model wears: 0 .. 1
uniform bool u_is_paper;    // what it is made of: paper or clay
uniform float u_inflation;

centroid in vec3 v_normal;
centroid in vec2 v_place;

out vec4 colour;

vec3 bare(vec3 normal) { return u_is_paper ? paper_colour(normal) : clay_colour(normal); }

vec3 worn(vec3 normal) {
  vec3 drawn = texture(u_drawing, v_place).rgb;
  // Flat on the paper it has to look as it was drawn.
  return mix(drawn, softly_lit(drawn, normal), clamp(u_inflation, 0.0, 1.0));
}

void main() {
  vec3 normal = surface_normal(v_normal, gl_FrontFacing);
  colour.a = 1.0;
  if (u_worn <= 0.0) {
    colour.rgb = bare(normal);
  } else if (u_worn >= 1.0) {
    colour.rgb = worn(normal);
  } else {
    colour.rgb = mix(bare(normal), worn(normal), u_worn);
  }
}
