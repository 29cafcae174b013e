// SPDX-License-Identifier: Apache-2.0
#include "simplify/widest_opening.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "simplify/cut_parts.h"
#include "simplify/loose_ends.h"

namespace inkflate {
namespace {

// Each end is compared with each other one.
constexpr std::ptrdiff_t kMostEnds = 256;

// Beyond it numbers are too large for the working space; canvas px.
constexpr double kFarthestPx = 1e6;

/// The places of loose ends, work px; of too many those of the longest strokes.
std::vector<Vec2> end_places(Sketch const& sketch, StrokeSamples const& samples) {
  auto ends = loose_ends(sketch, samples);
  std::stable_sort(ends.begin(), ends.end(),
                   [](LooseEnd const& a, LooseEnd const& b) { return a.length_px > b.length_px; });
  ends.resize(static_cast<std::size_t>(std::min(kMostEnds, std::ssize(ends))));
  std::vector<Vec2> places;
  places.reserve(ends.size());
  for (auto const& end : ends) places.push_back(samples.points[end.sample].position);
  return places;
}

}  // namespace

Vec2 widest_opening(Sketch const& sketch) {
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  if (box.is_empty()) return {};
  auto const is_far = [](Vec2 p) {
    return !(std::abs(p.x) <= kFarthestPx && std::abs(p.y) <= kFarthestPx);
  };
  if (is_far(box.min) || is_far(box.max)) return box.centre();
  auto const space = WorkSpace::around(box);
  std::vector<int> all(sketch.strokes.size());
  std::iota(all.begin(), all.end(), 0);
  auto const places = end_places(sketch, sample_strokes(sketch, all, space, kCutSpacingPx));
  double widest = 0;
  Vec2 middle = space.work_point(box.centre());
  for (int i = 0; i < std::ssize(places); ++i) {
    int nearest = -1;
    for (int j = 0; j < std::ssize(places); ++j) {
      if (j == i) continue;
      if (nearest < 0 || distance(places[i], places[j]) < distance(places[i], places[nearest]))
        nearest = j;
    }
    if (nearest < 0 || distance(places[i], places[nearest]) <= widest) continue;
    widest = distance(places[i], places[nearest]);
    middle = lerp(places[i], places[nearest], 0.5);
  }
  return space.canvas_point(middle);
}

}  // namespace inkflate
