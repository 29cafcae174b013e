// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/vec2.h"

namespace inkflate {

/// What slow iterations tend to, by Anderson's acceleration over the last ten. Where the energy would rise, it begins anew from the
/// plain iteration.
///
/// in      step: makes the next pose of one, with no more energy
/// out     nothing moves by more than 1e-7 px any more, or most_iterations are done
/// source  Peng et al. 2018, "Anderson Acceleration for Geometry Optimization and Physics Simulation"
std::vector<Vec2> fixed_point(std::vector<Vec2> pose,
                              std::function<void(std::vector<Vec2>&)> const& step,
                              std::function<double(std::span<Vec2 const>)> const& energy,
                              int most_iterations);

}  // namespace inkflate
