// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// How far a pose can go along its moves until the first triangle has no area any more: the least t > 0 at which one of
/// pose + t * moves has none; infinite when there is none.
///
/// in      every triangle of the pose has positive area
/// source  Smith and Schaefer 2015, section 3.3: the area is a quadratic polynomial in t
double step_bound(std::span<Triangle const> triangles, std::span<Vec2 const> pose,
                  std::span<Vec2 const> moves);

}  // namespace inkflate
