// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "base/progress.h"
#include "base/result.h"
#include "image/grid2.h"
#include "ink/trace_scan.h"
#include "model/drawing.h"
#include "pipeline/place_sketch.h"
#include "simplify/simplify.h"

namespace inkflate {

/// What simplify can start from: strokes, or a scan whose strokes are found first.
using SketchSource = std::variant<Sketch, Picture>;

struct RunSimplifyOptions {
  ScanOptions scan;          // for a Picture
  PlaceOptions place;        // the canvas of the output
  SimplifyOptions simplify;  // lengths and places in px of that canvas
};

/// From a sketch or a scan to closed contours on the wanted canvas. A StageClock on the progress takes the times.
///
/// errors  those of trace_scan, place_sketch and simplify
/// cost    that of its stages
Result<Drawing> run_simplify(SketchSource const& source, RunSimplifyOptions const& options = {},
                             Progress const& progress = {});

}  // namespace inkflate
