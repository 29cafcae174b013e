// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "base/result.h"
#include "model/stroke.h"

namespace inkflate {

enum class PlaceMode {
  WholeCanvas,  // the canvas keeps its shape and is scaled as a whole
  FitStrokes,   // a square canvas; the strokes fill it but for a margin
};

struct PlaceOptions {
  std::optional<double> size_px;  // 1 .. kMaxSizePx: longer side of the canvas; none: the sketch's
  PlaceMode mode = PlaceMode::WholeCanvas;

  static constexpr double kMaxSizePx = 16384;  // a picture of the canvas is no larger than we read
};

/// Moves and scales a sketch onto the canvas that the output shall have; widths are scaled too.
///
/// in      sketch: samples finite
/// out     FitStrokes: the bounding box of all strokes with at least two samples gets a longer side of 0.86 times
///         the canvas and its centre; dots do not count, since most are accidents. A box without size is only
///         centred. WholeCanvas without a size: the sketch as it is.
/// errors  BadOption (size out of range); NothingThere (WholeCanvas with a size, but the canvas has none)
/// cost    O(samples)
Result<Sketch> place_sketch(Sketch const& sketch, PlaceOptions const& options);

}  // namespace inkflate
