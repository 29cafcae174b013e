// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "base/rng.h"
#include "geometry/crossings.h"
#include "io/read_svg.h"
#include "io/write_svg.h"
#include "pipeline/place_sketch.h"
#include "simplify/simplify.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// A drawing and how to simplify it. Made of one number, so a failure is known by its seed.
struct Case {
  Sketch sketch;
  SimplifyOptions options;
};

std::vector<Vec2> arbitrary_marks(Rng& rng) {
  std::vector<Vec2> marks;
  for (int i = rng.below(4) == 0 ? 1 + rng.below(3) : 0; i > 0; --i)
    marks.push_back({rng.uniform(0, 1000), rng.uniform(0, 1000)});
  return marks;
}

SimplifyOptions arbitrary_options(Rng& rng) {
  SimplifyOptions options;
  if (rng.below(3) == 0) options.gap_px = rng.uniform(0.1, 400);
  options.outside = arbitrary_marks(rng);
  options.inside = arbitrary_marks(rng);
  options.holes = rng.below(2) == 0 ? Holes::Keep : Holes::Fill;
  options.parts = static_cast<Parts>(rng.below(3));
  options.smooth = rng.below(3) == 0 ? rng.below(2) : rng.uniform();
  return options;
}

Case arbitrary_case(std::uint64_t seed) {
  Case made = {random_sketch(seed), {}};
  Rng rng(~seed);
  made.options = arbitrary_options(rng);
  for (int i = rng.below(4); i > 0; --i) made.sketch.groups.push_back({"group"});
  int const group_count = static_cast<int>(made.sketch.groups.size());
  for (auto& stroke : made.sketch.strokes) stroke.group = rng.below(group_count + 1) - 1;
  return made;
}

constexpr double kGridCanvasPx = 80;

/// The same on a canvas on which pixels are cheap; there the gap is not limited.
Case arbitrary_grid_case(std::uint64_t seed) {
  auto made = arbitrary_case(seed);
  made.options.method = SimplifyMethod::Grid;
  made.options.gap_px.reset();
  for (auto* marks : {&made.options.outside, &made.options.inside}) {
    for (auto& mark : *marks) mark *= kGridCanvasPx / made.sketch.width_px;
  }
  made.sketch = *place_sketch(made.sketch, {kGridCanvasPx, PlaceMode::WholeCanvas});
  return made;
}

/// Nothing enclosed, an inside mark beyond the strokes, or tiny strokes far from the origin.
bool is_fair_refusal(Error const& error) {
  return error.code == ErrorCode::NothingThere || error.code == ErrorCode::BadOption ||
         error.code == ErrorCode::BadInput;
}

/// Of all filled shapes; 0 when there is none.
double area(Result<Drawing> const& drawing) {
  double sum = 0;
  if (!drawing) return sum;
  for (auto const& layer : drawing->layers) sum += signed_area(flatten(layer.outlines[0], 0.05));
  return sum;
}

double strokes_size_px(Sketch const& sketch) {
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  return box.longer_side();
}

RC_GTEST_PROP(Simplify, EndsValidOrRefused, (std::uint64_t seed)) {
  auto const [sketch, options] = arbitrary_case(seed);
  auto const drawing = simplify(sketch, options);
  if (drawing) {
    RC_ASSERT(what_is_wrong(*drawing) == std::string());
  } else {
    RC_ASSERT(is_fair_refusal(drawing.error()));
  }
}

RC_GTEST_PROP(Simplify, TheGridEndsValidOrRefused, (std::uint64_t seed)) {
  auto const [sketch, options] = arbitrary_grid_case(seed);
  auto const drawing = simplify(sketch, options);
  if (drawing) {
    RC_ASSERT(what_is_wrong(*drawing) == std::string());
  } else {
    RC_ASSERT(is_fair_refusal(drawing.error()));
  }
}

RC_GTEST_PROP(Simplify, OutlinesStaySimpleAsCoarseAndFinePolygons, (std::uint64_t seed)) {
  auto const [sketch, options] = arbitrary_case(seed);
  auto const drawing = simplify(sketch, options);
  RC_PRE(drawing.has_value());
  for (double const tolerance : {1e-5, 2e-4}) {
    for (auto const& layer : drawing->layers) {
      for (auto const& outline : layer.outlines)
        RC_ASSERT(is_simple(flatten(outline, tolerance * strokes_size_px(sketch))));
    }
  }
}

RC_GTEST_PROP(Simplify, WrittenAndReadIsEqual, (std::uint64_t seed)) {
  auto const [sketch, options] = arbitrary_case(seed);
  auto const drawing = simplify(sketch, options);
  RC_PRE(drawing.has_value());
  std::string const text = write_svg(*drawing);
  auto const again = read_svg(std::as_bytes(std::span(text)));
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == *drawing);
}

RC_GTEST_PROP(Simplify, TwiceTheSameIsEqual, (std::uint64_t seed)) {
  auto const [sketch, options] = arbitrary_case(seed);
  auto const once = simplify(sketch, options);
  auto const twice = simplify(sketch, options);
  RC_ASSERT(once.has_value() == twice.has_value());
  RC_PRE(once.has_value());
  RC_ASSERT(*once == *twice);
}

/// On a lattice on which mirroring about x = 500 is exact.
Sketch on_lattice(Sketch sketch) {
  for (auto& stroke : sketch.strokes) {
    for (auto& sample : stroke.samples) {
      auto& p = sample.position;
      p = Vec2{std::floor(p.x * 16 + 0.5), std::floor(p.y * 16 + 0.5)} / 16;
    }
  }
  return sketch;
}

Sketch mirrored(Sketch sketch) {
  for (auto& stroke : sketch.strokes) {
    for (auto& sample : stroke.samples) sample.position.x = 1000 - sample.position.x;
  }
  return sketch;
}

// Not a law for every drawing: where two ways to close one cost nearly the same, rounding decides.
TEST(Simplify, MirroringSeldomChangesTheShape) {
  int closed = 0;
  int different = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    auto const sketch = on_lattice(random_sketch(seed));
    double const left = area(simplify(sketch, {.holes = Holes::Fill}));
    double const right = area(simplify(mirrored(sketch), {.holes = Holes::Fill}));
    closed += left > 0 ? 1 : 0;
    different += std::abs(left - right) > 0.02 * std::max(left, right) ? 1 : 0;
  }
  EXPECT_GT(closed, 200);
  EXPECT_LE(different, closed / 50);
}

}  // namespace
}  // namespace inkflate
