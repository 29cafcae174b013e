// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "model/flat_model.h"

namespace inkflate {

/// The z of the middle between a layer's two sheets, per point of each layer, px: layers that overlap are moved apart and bent
/// gently, so that every rim lies on the right side of the sheets in front of and behind it, and limbs sit where they are joined.
///
/// in      heights: per layer, of layer_heights
/// out     per layer one z per point, finite. A lone layer stays at 0. At a Slit joint the ends of the limb's open run lie on the host's
///         sheet, and its middle does as far as the limb does not sink into the host; at a Mouth joint both middles agree. Where joints
///         and order want what cannot be, the order gives way
/// cost    about 1 ms for 5 layers of 1000 px, 15 ms for 21
/// source  docs/algorithms/depth.md; the aim is that of Dvoroznak et al. 2020 (Monster Mash), section 5 (ARAP-L, its z part)
std::vector<std::vector<double>> layer_depths(FlatModel const& model,
                                              std::span<std::vector<double> const> heights);

}  // namespace inkflate
