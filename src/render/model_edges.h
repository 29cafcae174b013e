// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "render/sample_band.h"

namespace inkflate {

struct EdgeOptions {
  double radius = 3;   // samples: half the width of the line
  double jump_px = 4;  // steps in depth below this are no edge
};

/// How many rows of samples above and below a row its edges depend on.
int edge_reach(EdgeOptions const& options);

/// The samples that a pen would ink: where the model ends, where it steps back behind itself, where two surfaces
/// meet at an angle. 255 or 0; the outermost edge_reach rows of the band are not to be relied on.
Mask ink_edges(DrawTriangles const& list, SampleGrid const& grid, SampleBand const& band,
               EdgeOptions const& options);

}  // namespace inkflate
