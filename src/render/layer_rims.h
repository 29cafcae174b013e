// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyline.h"
#include "model/rest_model.h"

namespace inkflate {

/// A stretch of the rim of a layer, on the canvas. One that is closed ends where it starts.
struct RimLine {
  Polyline points;
  std::vector<double>
      steepness;  // per point: how much longer a step from the rim is on the surface than on the canvas, >= 1
};

/// Where the front and the back of each layer meet. Open runs are no part of it.
///
/// out     per layer
/// cost    O(n log n)
std::vector<std::vector<RimLine>> layer_rims(RestModel const& model);

}  // namespace inkflate
