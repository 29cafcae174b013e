// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/drawing.h"

namespace inkflate {

/// An open run of a layer and the layer that it joins: what assemble would stitch.
struct JoinedRun {
  int limb = 0;  // index into Drawing::layers
  int host = 0;
  Polyline points;  // along the limb's outline, where it was drawn
};

/// in      drawing: its layers have outlines of finite points
/// cost    that of the first stage of assemble, without any mesh: O(open runs * layers * points)
std::vector<JoinedRun> joined_runs(Drawing const& drawing);

}  // namespace inkflate
