// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyline.h"
#include "model/rest_model.h"

namespace inkflate {

/// Where the front and the back of each layer meet, on the canvas, as lines; a line that is closed ends where it
/// starts. Open runs are no part of it.
///
/// out     per layer
/// cost    O(n log n)
std::vector<std::vector<Polyline>> layer_rims(RestModel const& model);

}  // namespace inkflate
