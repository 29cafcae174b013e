// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "editor/pick.h"
#include "geometry/polyline.h"
#include "geometry/predicates.h"

namespace inkflate {
namespace {

double squared_distance_between_segments(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (segments_touch(a, b, c, d)) return 0;
  return std::min({squared_distance_to_segment(a, c, d), squared_distance_to_segment(b, c, d),
                   squared_distance_to_segment(c, a, b), squared_distance_to_segment(d, a, b)});
}

// An eraser that only touches a line leaves it as it is: ends of strokes that it has cut lie on its edge, up to rounding. Of the
// radius, for small ones; in px for others.
constexpr double kTouch = 2e-6;

bool is_near(Stroke const& stroke, Vec2 from, Vec2 to, double radius_px) {
  double const reach_px = radius_px - kTouch * std::min(1.0, radius_px);
  auto const& samples = stroke.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    auto const before = samples[i == 0 ? 0 : i - 1].position;
    if (squared_distance_between_segments(before, samples[i].position, from, to) <
        reach_px * reach_px) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<int> strokes_near(StrokeList const& strokes, Vec2 from, Vec2 to, double radius_px) {
  Rect reach;
  reach.include(from);
  reach.include(to);
  reach = reach.grown(radius_px);
  std::vector<int> found;
  int index = 0;
  strokes.for_each([&](auto const& kept) {
    if (touch(kept->box, reach) && is_near(kept->stroke, from, to, radius_px)) {
      found.push_back(index);
    }
    ++index;
  });
  return found;
}

std::vector<StrokeRef> strokes_near(Document const& document, Vec2 from, Vec2 to,
                                    double radius_px) {
  std::vector<StrokeRef> found;
  auto const add = [&](LayerId layer, StrokeList const& strokes) {
    for (int const index : strokes_near(strokes, from, to, radius_px)) {
      found.push_back({layer, index});
    }
  };
  add(LayerId::None, document.loose);
  for (auto const& layer : *document.layers) {
    if (takes_strokes(layer->layer)) add(layer->layer.id, layer->strokes);
  }
  return found;
}

}  // namespace inkflate
