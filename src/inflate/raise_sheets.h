// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "model/flat_model.h"

namespace inkflate {

/// The model's vertex that each point of a layer is on each side. Where a slit cuts a sheet, one of its two lips.
struct SheetVertices {
  std::array<std::vector<int>, 2> of_point;  // per side; -1 for points without triangles
};

std::vector<SheetVertices> sheet_vertices(FlatModel const& model);

/// The model's vertices on the canvas with z towards the viewer: every sheet at its layer's depth, the front raised and the back
/// lowered by its height. Where a limb joins a slit, the slit's lips open to the limb's size, and the host's sheet follows them smoothly.
///
/// in      heights, depths: per layer one per point
/// cost    O(n + points of hosts * points of seams)
std::vector<Vec3> raise_sheets(FlatModel const& model, std::span<std::vector<double> const> heights,
                               std::span<std::vector<double> const> depths);

}  // namespace inkflate
