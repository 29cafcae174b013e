// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assemble/layer_rim.h"
#include "model/flat_model.h"

namespace inkflate {

/// An open run that joins another layer.
struct PlannedJoint {
  int limb = 0;             // layer
  int run = 0;              // of the limb's rim
  int host = 0;             // layer
  int host_run = -1;        // for a mouth: the open run of the host's rim that it meets
  Side side = Side::Front;  // of the host, for a slit
};

/// Decides which runs are open and what they join, and moves them where that needs it: a run that ends a little short of its host, or
/// on the host's rim, is pushed into it, and two mouths that nearly meet are brought together.
///
/// in      rims: of all layers, back to front; unit_px: a thousandth of the drawing's size
/// out     rims: an Opening other than None now means an open boundary; a joint's run lies strictly inside its host's area, clear of
///         the host's rim and of other joints' runs. Every outer contour is as simple as it was
/// cost    O(open runs * layers * points)
std::vector<PlannedJoint> plan_joints(std::vector<LayerRim>& rims, double unit_px);

}  // namespace inkflate
