// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/stroke.h"

namespace inkflate {

/// Takes the tremble of a hand out of a line while it is drawn. Each sample becomes the mean of the line around it, over a window of
/// the line's own length that is as long before as behind. Towards an end the window shrinks to nothing: the line starts and ends
/// exactly where the pen is, at any time, and never lags behind it. Where the line turns sharply the window shrinks too, so that
/// corners and small circles stay. Pressure and time stay as they are.
///
/// Why length and not time: a slow hand trembles and leaves many samples in a window, a fast one does not and leaves few; so the
/// amount of smoothing follows the speed, and events that come in bundles do no harm.
///
/// in      smooth: what this made of all samples of raw but the last ones (empty: of none); half_width_px >= 0, the same each time
/// out     smooth: of all of raw, the same as if made at once
/// cost    O(k^2) for k samples within two windows, and for new ones
/// source  ink-stroke-modeler, wobble smoother: a moving average, for slow strokes only; here symmetric instead of trailing, since the
///         last stretch may still change. The kernel: Epanechnikov 1969
void smooth_end(std::vector<Sample> const& raw, double half_width_px, std::vector<Sample>& smooth);

}  // namespace inkflate
