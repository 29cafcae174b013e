// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/vec2.h"
#include "geometry/vec3.h"

namespace inkflate {

/// Three different vertices.
using Triangle = std::array<int, 3>;

/// Triangles in the plane, canvas px; each has positive shoelace area (geometry/polyline.h).
struct FlatMesh {
  std::vector<Vec2> points;
  std::vector<Triangle> triangles;

  friend bool operator==(FlatMesh const&, FlatMesh const&) = default;
};

/// Triangles in space. Of a closed mesh each one is counter-clockwise as seen from outside.
struct TriMesh {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;

  friend bool operator==(TriMesh const&, TriMesh const&) = default;
};

}  // namespace inkflate
