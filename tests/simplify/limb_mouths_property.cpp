// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "base/rng.h"
#include "simplify/limb_mouths.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// A point of a limb that leaves a place in a direction.
struct LimbFrame {
  Vec2 origin;
  Vec2 direction;

  Vec2 at(double along, double aside) const {
    return origin + direction * along + perpendicular(direction) * aside;
  }
};

/// One side of a limb, drawn once or twice with a trembling hand.
void add_side(LimbFrame const& frame, double length, double aside, Rng& rng,
              std::vector<Stroke>& strokes) {
  for (int pass = 1 + rng.below(2); pass > 0; --pass) {
    std::vector<Vec2> points;
    double const start = rng.uniform(0, 20);
    for (double along = start; along < length; along += 12)
      points.push_back(frame.at(along, aside * (1 - 0.4 * along / length) + rng.uniform(-2, 2)));
    points.push_back(frame.at(length + 15, 0));
    strokes.push_back(line_stroke(points));
  }
}

/// A round body and some limbs that start at its rim, shortly before it, or within it.
Sketch random_character(std::uint64_t seed) {
  Rng rng(seed);
  Sketch sketch = sketch_of({arc_stroke({500, 500}, 200, 160, 0, 2 * M_PI)});
  sketch.groups = {{"body"}, {"limbs"}, {"more limbs"}};
  sketch.strokes[0].group = 0;
  for (int limb = 2 + rng.below(5); limb > 0; --limb) {
    double const angle = rng.uniform(0, 2 * M_PI);
    Vec2 const direction = {std::cos(angle), std::sin(angle)};
    LimbFrame const frame = {Vec2{500, 500} + direction * rng.uniform(80, 230), direction};
    double const length = rng.uniform(60, 300);
    double const half_width = rng.uniform(8, 50);
    std::vector<Stroke> strokes;
    add_side(frame, length, half_width, rng, strokes);
    add_side(frame, length, -half_width, rng, strokes);
    for (int band = rng.below(4); band > 0; --band) {
      double const along = rng.uniform(0, length);
      strokes.push_back(
          line_stroke({frame.at(along, half_width * 1.1), frame.at(along, -half_width * 1.1)}));
    }
    int const group = 1 + rng.below(2);
    for (auto& stroke : strokes) {
      stroke.group = group;
      sketch.strokes.push_back(std::move(stroke));
    }
  }
  return sketch;
}

double limb_area(Drawing const& drawing) {
  double sum = 0;
  for (auto const& layer : drawing.layers) {
    if (layer.name != "body" && layer.name != "construction")
      sum += signed_area(flatten(layer.outlines[0], 0.1));
  }
  return sum;
}

RC_GTEST_PROP(LimbMouths, DrawingsStayValid, (std::uint64_t seed)) {
  auto const sketch = random_character(seed);
  auto const drawing = simplify(sketch, {.parts = Parts::Groups});
  RC_ASSERT(drawing.has_value());
  RC_ASSERT(what_is_wrong(*drawing) == std::string());
  RC_ASSERT(drawing->sketch == sketch);
}

RC_GTEST_PROP(LimbMouths, ABodyTakesNothingFromItsLimbs, (std::uint64_t seed)) {
  auto sketch = random_character(seed);
  auto const joined = simplify(sketch, {.parts = Parts::Groups});
  sketch.groups[0].name = "construction";
  sketch.groups[2].name = "construction";  // else limbs of one group may end on those of the other
  auto const alone = simplify(sketch, {.parts = Parts::Groups});
  RC_ASSERT(joined.has_value());
  RC_PRE(alone.has_value());
  RC_ASSERT(limb_area(*joined) >= 0.99 * limb_area(*alone));
}

RC_GTEST_PROP(LimbMouths, TwiceTheSameIsEqual, (std::uint64_t seed)) {
  auto const sketch = random_character(seed);
  auto const once = simplify(sketch, {.parts = Parts::Groups});
  auto const twice = simplify(sketch, {.parts = Parts::Groups});
  RC_ASSERT(once.has_value() && twice.has_value());
  RC_ASSERT(*once == *twice);
}

}  // namespace
}  // namespace inkflate
