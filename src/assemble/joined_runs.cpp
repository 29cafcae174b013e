// SPDX-License-Identifier: Apache-2.0
#include "assemble/joined_runs.h"

#include "assemble/drawing_rims.h"
#include "assemble/plan_joints.h"

namespace inkflate {

std::vector<JoinedRun> joined_runs(Drawing const& drawing) {
  Drawing closed;
  std::vector<int> places;  // of the closed layers among all
  for (int i = 0; i < std::ssize(drawing.layers); ++i) {
    auto const& layer = drawing.layers[i];
    if (layer.outlines.empty() || layer.outlines.front().pieces.empty()) continue;
    closed.layers.push_back(layer);
    places.push_back(i);
  }
  if (closed.layers.size() < 2) return {};
  double const unit_px = drawing_unit(closed);
  if (!(unit_px > 0)) return {};
  auto const rims = drawing_rims(closed, unit_px);
  auto pushed = rims;
  std::vector<JoinedRun> joined;
  for (auto const& joint : plan_joints(pushed, unit_px)) {
    // As it was drawn, not as it was pushed into its host: a push replaces points, not runs.
    joined.push_back(
        {places[joint.limb], places[joint.host], rims[joint.limb].runs[joint.run].points});
  }
  return joined;
}

}  // namespace inkflate
