// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/write_model.h"

#include <span>

#include "io/put_bytes.h"

namespace inkflate::web {
namespace {

using Bytes = std::vector<std::byte>;

/// What each corner of each triangle has there.
void put_corners(std::vector<Triangle> const& triangles, std::vector<Vec3> const& values,
                 Bytes& bytes) {
  bytes.reserve(bytes.size() + 36 * triangles.size());
  for (auto const& triangle : triangles) {
    for (int const vertex : triangle) {
      auto const value = values[static_cast<std::size_t>(vertex)];
      for (double const number : {value.x, value.y, value.z}) put_float32(bytes, number);
    }
  }
}

void put_layers(std::vector<Face> const& faces, Bytes& bytes) {
  for (auto const& face : faces) {
    for (int corner = 0; corner < 3; ++corner) put_float32(bytes, face.layer);
  }
}

void put_places(std::vector<std::array<Vec2, 3>> const& corners, Bytes& bytes) {
  for (auto const& triangle : corners) {
    for (auto const place : triangle) {
      put_float32(bytes, place.x);
      put_float32(bytes, place.y);
    }
  }
}

}  // namespace

Json mesh_json(RestModel const& model, Texture const* texture, BlobWriter& blobs) {
  static Texture const none;
  auto const& worn = texture ? *texture : none;
  auto const& triangles = model.mesh.triangles;
  return {
      {"positions",
       blobs.add_written([&](auto& b) { put_corners(triangles, model.mesh.points, b); })},
      {"normals", blobs.add_written([&](auto& b) { put_corners(triangles, model.normals, b); })},
      {"places", blobs.add_written([&](auto& b) { put_places(worn.corners, b); })},
      {"layers", blobs.add_written([&](auto& b) { put_layers(model.faces, b); })},
      {"layerCount", model.layer_names.size()},
      {"textureWidth", worn.picture.width},
      {"textureHeight", worn.picture.height},
      {"texture", blobs.add(std::as_bytes(std::span(worn.picture.values)))},
  };
}

}  // namespace inkflate::web
