// SPDX-License-Identifier: Apache-2.0
#include "io/file_vertices.h"

#include "base/check.h"

namespace inkflate {
namespace {

/// Gives each pair of a model's vertex and a place in the texture a vertex of the file.
class Splitter {
 public:
  Splitter(std::size_t vertex_count, bool has_uvs) : first_(vertex_count, -1), has_uvs_(has_uvs) {}

  int vertex(int source, Vec2 uv) {
    int* slot = &first_[static_cast<std::size_t>(source)];
    while (*slot >= 0 && has_uvs_ && split_.uvs[static_cast<std::size_t>(*slot)] != uv) {
      slot = &next_[static_cast<std::size_t>(*slot)];
    }
    if (*slot >= 0) return *slot;
    int const added = static_cast<int>(std::ssize(split_.sources));
    *slot = added;  // before next_ grows, for the slot may lie in it
    next_.push_back(-1);
    split_.sources.push_back(source);
    if (has_uvs_) split_.uvs.push_back(uv);
    return added;
  }

  FileVertices take(std::vector<Triangle> triangles) {
    split_.triangles = std::move(triangles);
    return std::move(split_);
  }

 private:
  std::vector<int> first_;  // per vertex of the model its first vertex of the file, else -1
  std::vector<int> next_;   // per vertex of the file the next one of the same vertex, else -1
  bool has_uvs_;
  FileVertices split_;
};

}  // namespace

FileVertices file_vertices(RestModel const& model, Texture const* texture) {
  auto const& triangles = model.mesh.triangles;
  CHECK(texture == nullptr || texture->corners.size() == triangles.size(),
        "a texture has corners for every triangle");
  Splitter splitter(model.mesh.points.size(), texture != nullptr);
  std::vector<Triangle> split;
  split.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangle corners = {};
    for (std::size_t c = 0; c < 3; ++c) {
      Vec2 const uv = texture != nullptr ? texture->corners[i][c] : Vec2{};
      corners[c] = splitter.vertex(triangles[i][c], uv);
    }
    split.push_back(corners);
  }
  return splitter.take(std::move(split));
}

}  // namespace inkflate
