// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/stroke.h"

namespace inkflate {

/// Construction lines: strokes much paler than the drawing. Artists leave them under the ink, and closing a shape along one (a ground line
/// under the feet, say) is never meant.
///
/// out     per stroke, whether it is faint: less than half as far from white, in the channel that is farthest, as the middle one of
///         all strokes by length. So a saturated colour is never faint, and neither is anything in a drawing that is pale all over
/// cost    O(samples + strokes log strokes)
std::vector<bool> faint_strokes(Sketch const& sketch);

}  // namespace inkflate
