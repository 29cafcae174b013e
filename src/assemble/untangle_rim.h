// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assemble/layer_rim.h"

namespace inkflate {

/// A rim that crosses itself, as where a part was bent over itself, becomes the boundary of its area: all that its contours wind around.
/// What two sides enclose between them is a hole then. Stretches of it are open as the runs were that they come from, if at least half
/// of such a run is left. Of several pieces that are apart the largest is kept; slits and specks narrower than step_px are filled.
///
/// out     a simple rim with an outer contour of positive area and holes of negative; one that was so stays as it is, to the last bit,
///         and so does one that encloses nothing
/// cost    O(n) for a simple one, else that of nonzero_boundary
LayerRim untangled(LayerRim rim, double step_px);

}  // namespace inkflate
