// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "model/flat_model.h"

namespace inkflate {

/// Smooths the surface where layers join, so that it runs on from one into the other without an edge.
///
/// in      model; triangles: all of the model's, in space; points: its vertices, of raise_sheets
/// out     points: moved near joints only
/// cost    O(vertices near joints)
void shape_joints(FlatModel const& model, std::span<Triangle const> triangles,
                  std::vector<Vec3>& points);

}  // namespace inkflate
