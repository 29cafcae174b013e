// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "mesh/tri_mesh.h"

namespace inkflate {

struct SolidifyOptions {
  double longest_mm = 100;     // 5 .. 1000: the model's longest side when printed
  double least_mm = 1.2;       // 0 .. 20, <= longest_mm / 2: nothing is thinner, nor than 1.3 cells
  bool has_flat_base = false;  // cut flat at the bottom so that it stands
  int cells = 160;             // 16 .. 512: grid cells along the longest side
};

/// One watertight shell around a model whose parts overlap, ready to print: what lies inside is gone, thin places are thickened, all
/// edges have two triangles and no triangle passes through another.
///
/// in      model: closed; y up; any number of shells that may pass through each other
/// out     mm, z up (the model's y), standing on z = 0, the model's front facing -y, its middle over the origin. Pieces that touch
///         nothing stay shells of their own; voids inside are filled
/// errors  BadOption; BadInput (not closed); NothingThere; TooLarge; Cancelled
/// cost    O(cells^3 + n log n); about 0.3 s for 160 cells
/// source  docs/algorithms/solidify.md
Result<TriMesh> solidify(TriMesh const& model, SolidifyOptions const& options = {},
                         Progress const& progress = {});

}  // namespace inkflate
