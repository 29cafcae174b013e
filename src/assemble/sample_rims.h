// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "assemble/plan_joints.h"

namespace inkflate {

/// A layer's boundary with the points that the mesh will have.
struct SampledRim {
  std::vector<Polyline> runs;  // as LayerRim::runs
  std::vector<Contour> holes;

  /// All contours, the outer one first.
  std::vector<Contour> contours() const;
};

/// Takes as many points from every rim as its mesh needs: few where a layer is wide, more where it is thin. Open runs get at least three
/// points, and the same ones on both sides of a mouth. Where the points would make a rim cross itself, more are taken.
///
/// out     one per layer; an outer rim that crosses itself however finely it is sampled stays so, a hole is filled
std::vector<SampledRim> sample_rims(std::span<LayerRim const> rims,
                                    std::span<PlannedJoint const> plan, double unit_px,
                                    double density);

}  // namespace inkflate
