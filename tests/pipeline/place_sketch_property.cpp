// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "geometry/rect.h"
#include "pipeline/place_sketch.h"

namespace inkflate {
namespace {

// Lattice points: distinct ones lie far enough apart for every scale used here.
Sketch arbitrary_sketch() {
  Sketch sketch = {100, 100, {}, {}};
  int const stroke_count = *rc::gen::inRange(1, 5);
  for (int i = 0; i < stroke_count; ++i) {
    Stroke stroke;
    int const sample_count = *rc::gen::inRange(2, 12);
    for (int k = 0; k < sample_count; ++k) {
      double const x = *rc::gen::inRange(-1000000, 1000000);
      double const y = *rc::gen::inRange(-1000000, 1000000);
      stroke.samples.push_back({{x, y}, 1});
    }
    sketch.strokes.push_back(stroke);
  }
  return sketch;
}

Rect sample_bounds(Sketch const& sketch) {
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  return box;
}

RC_GTEST_PROP(PlaceSketch, FittedStrokesKeepTheirMargin, ()) {
  double const size_px = *rc::gen::inRange(1, 16384);
  auto const placed = place_sketch(arbitrary_sketch(), {size_px, PlaceMode::FitStrokes});
  RC_ASSERT(placed.has_value());
  Rect const box = sample_bounds(*placed);
  double const margin_px = 0.07 * size_px * (1 - 1e-9);
  RC_ASSERT(box.min.x >= margin_px && box.min.y >= margin_px);
  RC_ASSERT(box.max.x <= size_px - margin_px && box.max.y <= size_px - margin_px);
}

RC_GTEST_PROP(PlaceSketch, FittingTwiceIsFittingOnce, ()) {
  PlaceOptions const options = {1024, PlaceMode::FitStrokes};
  auto const once = place_sketch(arbitrary_sketch(), options);
  auto const twice = place_sketch(*once, options);
  for (int i = 0; i < static_cast<int>(once->strokes.size()); ++i) {
    auto const& a = once->strokes[i].samples;
    auto const& b = twice->strokes[i].samples;
    for (int k = 0; k < static_cast<int>(a.size()); ++k) {
      RC_ASSERT(distance(a[k].position, b[k].position) < 1e-9);
    }
  }
}

}  // namespace
}  // namespace inkflate
