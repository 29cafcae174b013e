// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "simplify/rim.h"
#include "simplify/simplify.h"

namespace inkflate {

/// Distance of the samples for the cut, work px. Half of it changes no result that a person sees, twice of it opens small gaps.
inline constexpr double kCutSpacingPx = 2.5;

/// What the minimum cut makes of some strokes, before anything is smoothed.
struct CutParts {
  Cells cells;
  std::vector<std::vector<Rim>>
      parts;  // largest first; of each its outer rim, then those of its holes
};

/// Cuts, carves holes, traces, and drops what is no shape.
///
/// in      samples: of strokes of the sketch, with chords if it may close along them; space: in which they are
/// out     simple rims without samples of chords; no parts when nothing is enclosed, or a rim without its chords is not simple
/// errors  BadOption (an inside mark beyond the strokes), Cancelled
/// source  docs/algorithms/simplify.md
Result<CutParts> cut_parts(Sketch const& sketch, StrokeSamples samples, WorkSpace const& space,
                           SimplifyOptions const& options, Progress const& progress);

/// Centres and smooths the rims: one layer for each part, with outlines and nothing else.
///
/// errors  Cancelled
Result<std::vector<Layer>> fit_parts(CutParts const& cut, WorkSpace const& space, double smooth,
                                     Progress const& progress);

}  // namespace inkflate
