// SPDX-License-Identifier: Apache-2.0
#include "deform/bend_mesh.h"

#include "base/check.h"

namespace inkflate {

BendAnchor corner_anchor(int triangle, int corner) {
  BendAnchor anchor = {triangle, {0, 0, 0}};
  anchor.weights[corner] = 1;
  return anchor;
}

Vec2 place_of(FlatMesh const& mesh, std::span<Vec2 const> pose, BendAnchor const& anchor) {
  CHECK(anchor.triangle >= 0 && anchor.triangle < std::ssize(mesh.triangles),
        "an anchor of this mesh");
  auto const& [a, b, c] = mesh.triangles[anchor.triangle];
  return pose[a] * anchor.weights[0] + pose[b] * anchor.weights[1] + pose[c] * anchor.weights[2];
}

}  // namespace inkflate
