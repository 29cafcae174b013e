// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "simplify/simplify.h"
#include "simplify/stroke_samples.h"

namespace inkflate {

/// What the strokes of one group became.
struct ClosedStrokes {
  std::vector<Layer> layers;  // largest first, without names
  std::vector<int> stray;
};

/// Closes some strokes of a sketch by one method or the other.
///
/// in      chosen: indices into sketch.strokes; frame: around all strokes of the sketch; options: valid
/// out     no layer at all when nothing is enclosed
/// errors  by_cut: BadOption (an inside mark beyond the strokes), Cancelled; by_grid: those of close_on_grid but NothingThere
/// source  docs/algorithms/simplify.md
Result<ClosedStrokes> close_by_cut(Sketch const& sketch, std::span<int const> chosen,
                                   Frame const& frame, SimplifyOptions const& options,
                                   Progress const& progress);
Result<ClosedStrokes> close_by_grid(Sketch const& sketch, std::span<int const> chosen,
                                    Frame const& frame, SimplifyOptions const& options,
                                    Progress const& progress);

}  // namespace inkflate
