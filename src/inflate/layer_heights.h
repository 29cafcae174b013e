// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/flat_model.h"

namespace inkflate {

/// How far each point of a layer's sheets lies from the middle between them, px, >= 0.
///
/// L u = c M with u = 0 on the drawn rim and free on open runs (natural boundary), then the square root of u. With c = 2 a long tube
/// is round, with c = 4 a disc becomes a half ball; heights grow with sqrt(c).
///
/// in      layer: at least one vertex is drawn rim
/// cost    one sparse factorisation: about 2 ms for 2000 points
/// source  Dvoroznak et al. 2020 (Monster Mash), section 4.2; thesis, section 2.1
std::vector<double> layer_heights(FlatLayer const& layer);

}  // namespace inkflate
