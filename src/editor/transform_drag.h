// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "editor/tool.h"
#include "geometry/affine.h"

namespace inkflate {

/// The map that a drag of a frame's handle means, from the press to now. Shift: moves along one axis, keeps proportions, turns in
/// steps of 15 degrees. Alt: scales about the centre.
///
/// out     finite, determinant not 0: a box is never made narrower than about 1 px. Nothing: the box would leave the plane of
///         DocumentLimits
std::optional<Affine> drag_map(ToolTransforming const& drag, ToolPointer const& now);

}  // namespace inkflate
