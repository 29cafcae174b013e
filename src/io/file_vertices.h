// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/rest_model.h"

namespace inkflate {

/// The vertices of a model as a file wants them that gives each vertex one place in the texture: those on a seam of the
/// texture stand several times.
struct FileVertices {
  std::vector<int> sources;         // per vertex of the file: the vertex of the model
  std::vector<Vec2> uvs;            // per vertex of the file; empty without a texture
  std::vector<Triangle> triangles;  // in the model's order
};

/// In the order in which the triangles use them; vertices that no triangle uses are left out. O(n)
///
/// in      texture: with corners for every triangle of the model; may be null
FileVertices file_vertices(RestModel const& model, Texture const* texture);

}  // namespace inkflate
