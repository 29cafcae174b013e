// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "simplify/group_limbs.h"
#include "simplify/simplify.h"
#include "simplify/work_space.h"

namespace inkflate {

/// Closes limbs where they are open towards another part. A limb is often drawn as a tube whose two sides end in the body; the cut closes it only if
/// its sides pay for the width of the mouth, and drops what lies before the nearest cross line otherwise. But there the other part covers
/// the gap, so here a chord between two loose ends over another group's area costs nothing.
///
/// in      groups: as the cut closes each by itself; is_faint: per stroke of the sketch, takes no part
/// out     layers of some groups are replaced, if that encloses clearly more; along the chords they are closings. The strokes of these layers are
///         not set, and the indices of these groups are returned
/// errors  Cancelled
/// cost    finding loose ends is linear in the samples; a limb that has some over another group is cut again once for each pair, at
///         most 66 times for each part it may join
Result<std::vector<int>> close_limb_mouths(Sketch const& sketch, std::vector<bool> const& is_faint,
                                           WorkSpace const& space, SimplifyOptions const& options,
                                           Progress const& progress,
                                           std::vector<GroupShapes>& groups);

}  // namespace inkflate
