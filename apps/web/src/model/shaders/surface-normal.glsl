// SPDX-License-Identifier: Apache-2.0
// src/render/surface_normal.cpp: the normal, turned to the viewer where the surface is seen from behind.

// Of a triangle just behind a silhouette a sample may show although a nearer one covers the pixel: it must not be lit from behind.
const float kGrazing = -0.3;

const vec3 kToViewer = vec3(0.0, 0.0, 1.0);

vec3 normalized(vec3 v) {
  float size = length(v);
  return size > 1e-6 ? v / size : kToViewer;
}

vec3 surface_normal(vec3 interpolated, bool is_front) {
  vec3 normal = normalized(interpolated);
  if (!is_front && !(normal.z > kGrazing && normal.z <= 0.0)) normal = -normal;
  // Near silhouettes a smooth normal may point away although the triangle is seen.
  return normal.z < 0.0 ? normalized(vec3(normal.xy, 0.0)) : normal;
}
