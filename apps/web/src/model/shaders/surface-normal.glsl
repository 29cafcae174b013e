// SPDX-License-Identifier: Apache-2.0
// src/render/surface_normal.cpp: the normal, turned to the viewer where the surface is seen from behind.

const vec3 kToViewer = vec3(0.0, 0.0, 1.0);

vec3 normalized(vec3 v) {
  float size = length(v);
  return size > 1e-6 ? v / size : kToViewer;
}

vec3 surface_normal(vec3 interpolated, bool is_front) {
  vec3 normal = normalized(is_front ? interpolated : -interpolated);
  // Near silhouettes a smooth normal may point away although the triangle is seen.
  return normal.z < 0.0 ? normalized(vec3(normal.xy, 0.0)) : normal;
}
