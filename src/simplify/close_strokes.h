// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "simplify/simplify.h"
#include "simplify/work_space.h"

namespace inkflate {

/// Closes some strokes of a sketch by one method or the other.
///
/// in      chosen: indices into sketch.strokes; space: around all strokes of the sketch; options: valid
/// out     layers with outlines and nothing else, largest first; none at all when nothing is enclosed
/// errors  by_cut: BadOption (an inside mark beyond the strokes), Cancelled; by_grid: those of close_on_grid but NothingThere
/// source  docs/algorithms/simplify.md
Result<std::vector<Layer>> close_by_cut(Sketch const& sketch, std::span<int const> chosen,
                                        WorkSpace const& space, SimplifyOptions const& options,
                                        Progress const& progress);
Result<std::vector<Layer>> close_by_grid(Sketch const& sketch, std::span<int const> chosen,
                                         SimplifyOptions const& options, Progress const& progress);

}  // namespace inkflate
