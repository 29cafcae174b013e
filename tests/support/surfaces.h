// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "mesh/check_mesh.h"
#include "model/flat_model.h"

namespace inkflate {

/// The sheets of a flat model as one surface. The points only tell the vertices apart: what counts is which triangles meet.
inline TriMesh surface_of(FlatModel const& model) {
  TriMesh mesh;
  for (int v = 0; v < model.vertex_count; ++v) {
    double const t = v;
    mesh.points.push_back({t, t * t, t * t * t});
  }
  for (auto const& layer : model.layers) {
    for (auto const& [a, b, c] : layer.sheets[0]) mesh.triangles.push_back({a, c, b});
    for (auto const& triangle : layer.sheets[1]) mesh.triangles.push_back(triangle);
  }
  for (auto const& cap : model.caps) mesh.triangles.push_back(cap.corners);
  return mesh;
}

/// Closed, 2-manifold and oriented; returns what was found for more questions.
inline MeshCheck sound_surface(FlatModel const& model) {
  auto const found = check_mesh(surface_of(model));
  EXPECT_EQ(found.boundary_edges, 0);
  EXPECT_EQ(found.non_manifold_edges, 0);
  EXPECT_EQ(found.non_manifold_vertices, 0);
  EXPECT_EQ(found.misoriented_edges, 0);
  EXPECT_EQ(found.bad_indices, 0);
  return found;
}

}  // namespace inkflate
