// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "model/drawing.h"
#include "model/flat_model.h"

namespace inkflate {

/// What becomes of open runs.
enum class OpenRuns {
  Joined,  // they join the nearest layer behind or in front of them; where there is none they are capped
  Capped,  // they end flat
  Holes,   // as Joined, but where there is no layer the surface stays open
};

struct AssembleOptions {
  OpenRuns open = OpenRuns::Joined;
  double density = 1;  // 0.1 .. 10: triangles per area, relative to the default
};

/// Meshes every layer, decides which runs are open, and stitches the layers along them.
///
/// in      drawing: its layers have outlines of finite points; they may cross themselves (untangle_rim.h)
/// out     a model whose sheets form a closed 2-manifold (OpenRuns::Holes apart)
/// errors  NothingThere (no layer, or all of them a single point); BadOption; BadInput (an outline encloses nothing or is too thin to be
///         meshed, a thickness out of range; index: the layer); Cancelled
/// cost    O(n log n) in the number of vertices
/// source  docs/algorithms/assemble.md
Result<FlatModel> assemble(Drawing const& drawing, AssembleOptions const& options = {},
                           Progress const& progress = {});

}  // namespace inkflate
