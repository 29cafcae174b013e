// SPDX-License-Identifier: Apache-2.0
#include "simplify/loose_ends.h"

#include "geometry/point_grid.h"

namespace inkflate {
namespace {

// What comes within this distance of an end goes on from it, work px: a slip of the pen.
constexpr double kReachPx = 10;

// Nearer than this, work px, there is no telling what lies ahead.
constexpr double kSamePx = 2;

// Ahead is what lies less than 60 degrees off the stroke's direction: cos.
constexpr double kAhead = 0.5;

// The direction of an end is taken over this many samples: a pen often hooks when it lifts.
constexpr int kDirectionReach = 6;

// Shorter strokes are dots and hatches, work px.
constexpr double kLeastLengthPx = 14;

class EndFinder {
 public:
  EndFinder(Sketch const& sketch, StrokeSamples const& samples)
      : sketch_(sketch), points_(samples.points), grid_(positions_of(samples.points), kReachPx) {}

  std::vector<LooseEnd> find() const {
    std::vector<LooseEnd> ends;
    int const count = static_cast<int>(std::ssize(points_));
    for (int first = 0; first < count;) {
      int last = first;
      double length = 0;
      for (; last + 1 < count && points_[last + 1].stroke == points_[first].stroke; ++last)
        length += distance(points_[last].position, points_[last + 1].position);
      if (!is_help(first) && length >= kLeastLengthPx) {
        int const reach = std::min(kDirectionReach, last - first);
        if (is_loose(first, first + reach)) ends.push_back({first, 1, length});
        if (is_loose(last, last - reach)) ends.push_back({last, -1, length});
      }
      first = last + 1;
    }
    return ends;
  }

 private:
  static std::vector<Vec2> positions_of(std::vector<StrokeSample> const& points) {
    std::vector<Vec2> positions;
    positions.reserve(points.size());
    for (auto const& point : points) positions.push_back(point.position);
    return positions;
  }

  bool is_help(int sample) const {
    return sketch_.strokes[points_[sample].stroke].kind == StrokeKind::HelpLine;
  }

  bool is_loose(int end, int before) const {
    auto const at = points_[end].position;
    auto const direction = normalized(at - points_[before].position);
    return !grid_.any_near(at, kReachPx, [&](int k) {
      auto const off = points_[k].position - at;
      double const squared = squared_norm(off);
      if (squared > kReachPx * kReachPx) return false;
      if (is_help(k)) return true;
      if (squared <= kSamePx * kSamePx) return false;
      double const along = dot(off, direction);
      return along > 0 && along * along > kAhead * kAhead * squared;
    });
  }

  Sketch const& sketch_;
  std::vector<StrokeSample> const& points_;
  PointGrid grid_;
};

}  // namespace

std::vector<LooseEnd> loose_ends(Sketch const& sketch, StrokeSamples const& samples) {
  return EndFinder(sketch, samples).find();
}

}  // namespace inkflate
