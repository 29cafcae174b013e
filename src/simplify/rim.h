// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/delaunay.h"
#include "model/drawing.h"
#include "simplify/stroke_samples.h"

namespace inkflate {

/// A corner of a rim: a stroke sample, and what the edge to the next corner is.
struct RimPoint {
  int sample = 0;
  RunKind to_next = RunKind::Ink;

  friend bool operator==(RimPoint const&, RimPoint const&) = default;
};

/// A closed polygon through stroke samples; no sample twice, no self-crossing. Outer rims have positive area, holes negative.
using Rim = std::vector<RimPoint>;

/// What the edge between two samples is: ink or help line up to the length of an ink edge, a closing above.
class EdgeKinds {
 public:
  EdgeKinds(Sketch const& sketch, StrokeSamples const& samples);
  RunKind operator()(int sample_a, int sample_b) const;

 private:
  StrokeSamples const* samples_;
  std::int64_t longest_ink_;
  std::vector<std::uint8_t> is_help_;  // per stroke
};

/// The rims of the cells labelled inside. Where cells meet only in a corner, the rims part.
///
/// in      inside: one label per triangle of mesh
/// out     every rim once, outer ones and holes
/// cost    O(cells)
std::vector<Rim> trace_rims(Triangulation const& mesh, std::span<std::uint8_t const> inside,
                            EdgeKinds const& kind_of);

/// The corner positions, frame px.
Contour positions(Rim const& rim, StrokeSamples const& samples);

}  // namespace inkflate
