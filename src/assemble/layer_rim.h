// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyline.h"
#include "model/drawing.h"

namespace inkflate {

/// Whether a run of a rim may become an open boundary.
enum class Opening {
  None,      // drawn
  Possible,  // a closing across the whole part: open if it joins another layer, else drawn
  Wanted,    // a help line: open in any case
};

/// A stretch of a layer's outer outline, finely sampled. It ends exactly where the next one starts.
struct RimRun {
  Polyline points;
  Opening opening = Opening::None;
};

/// A layer's boundary as fine polygons.
struct LayerRim {
  std::vector<RimRun>
      runs;  // the outer outline in order; one that is wholly drawn is a single run that ends where it starts
  std::vector<Contour> holes;
};

/// The outlines of a layer, sampled every step_px or finer. Neighbouring drawn runs are one. Help lines in holes count as drawn: nothing
/// can join a layer from within. Outlines that cross themselves or one another are untangled (untangle_rim.h).
LayerRim layer_rim(Layer const& layer, double step_px);

/// The outer outline as one polygon.
Contour outer_contour(LayerRim const& rim);

/// The line with points added so that no edge is longer than step_px.
Polyline densify(Polyline const& line, double step_px);

}  // namespace inkflate
