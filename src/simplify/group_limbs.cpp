// SPDX-License-Identifier: Apache-2.0
#include "simplify/group_limbs.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "geometry/point_grid.h"
#include "simplify/stroke_samples.h"

namespace inkflate {
namespace {

// Strokes nearer than this hang together, work px: about three times the width of a pencil line.
constexpr double kTouchPx = 7;

/// Tells which strokes of a group touch. They go by their place in the group's samples.
class StrokeContacts {
 public:
  explicit StrokeContacts(StrokeSamples const& samples)
      : points_(samples.points), grid_(positions_of(samples.points), kTouchPx) {
    for (int k = 0; k < std::ssize(points_); ++k) {
      if (k == 0 || points_[k].stroke != points_[k - 1].stroke) starts_.push_back(k);
      place_of_.push_back(static_cast<int>(std::ssize(starts_)) - 1);
    }
    starts_.push_back(static_cast<int>(std::ssize(points_)));
  }

  int count() const { return static_cast<int>(std::ssize(starts_)) - 1; }
  int stroke(int place) const { return points_[starts_[place]].stroke; }

  /// Calls visit(place) at least once for every stroke that touches this one, itself included.
  template <typename Visit>
  void touching(int place, Visit visit) const {
    for (int k = starts_[place]; k < starts_[place + 1]; ++k) {
      auto const at = points_[k].position;
      grid_.near(at, kTouchPx, [&](int other) {
        if (squared_norm(points_[other].position - at) <= kTouchPx * kTouchPx)
          visit(place_of_[other]);
      });
    }
  }

 private:
  static std::vector<Vec2> positions_of(std::vector<StrokeSample> const& points) {
    std::vector<Vec2> positions;
    positions.reserve(points.size());
    for (auto const& point : points) positions.push_back(point.position);
    return positions;
  }

  std::vector<StrokeSample> const& points_;
  PointGrid grid_;
  std::vector<int> starts_;    // per stroke its first sample, and the end
  std::vector<int> place_of_;  // per sample
};

std::vector<int> without(std::vector<bool> const& is_faint, std::vector<int> strokes) {
  std::erase_if(strokes, [&](int s) { return is_faint[s]; });
  std::sort(strokes.begin(), strokes.end());
  return strokes;
}

/// Adds stray strokes that hang together to the first of the limbs that one of them touches, or as a limb of their own.
void add_strays(Sketch const& sketch, std::vector<int> const& strays, WorkSpace const& space,
                std::vector<Limb>& limbs) {
  std::map<int, int> layer_of;  // per stroke in a layer
  std::vector<int> all = strays;
  for (auto const& limb : limbs) {
    all.insert(all.end(), limb.strokes.begin(), limb.strokes.end());
    for (int const stroke : limb.strokes) layer_of[stroke] = limb.layer;
  }
  auto const samples = sample_strokes(sketch, all, space, kTouchPx / 2);
  StrokeContacts const contacts(samples);
  std::vector<std::uint8_t> is_found(static_cast<std::size_t>(contacts.count()), 0);
  for (int seed = 0; seed < contacts.count(); ++seed) {
    if (is_found[seed] != 0 || layer_of.contains(contacts.stroke(seed))) continue;
    Limb found;
    std::vector<int> places = {seed};
    is_found[seed] = 1;
    for (std::size_t next = 0; next < places.size(); ++next) {
      found.strokes.push_back(contacts.stroke(places[next]));
      contacts.touching(places[next], [&](int place) {
        if (is_found[place] != 0) return;
        auto const known = layer_of.find(contacts.stroke(place));
        if (known != layer_of.end()) {
          found.layer = found.layer < 0 ? known->second : std::min(found.layer, known->second);
          return;
        }
        is_found[place] = 1;
        places.push_back(place);
      });
    }
    if (found.layer < 0) {
      limbs.push_back(std::move(found));
    } else {
      auto& strokes = limbs[found.layer].strokes;
      strokes.insert(strokes.end(), found.strokes.begin(), found.strokes.end());
    }
  }
}

}  // namespace

std::vector<Limb> group_limbs(Sketch const& sketch, GroupShapes const& group,
                              std::vector<bool> const& is_faint, WorkSpace const& space) {
  std::vector<Limb> limbs;
  for (int k = 0; k < std::ssize(group.layers); ++k) {
    auto strokes = group.layers[k].strokes;
    auto const& details = group.layers[k].details;
    strokes.insert(strokes.end(), details.begin(), details.end());
    limbs.push_back({without(is_faint, std::move(strokes)), k});
  }
  auto const strays = without(is_faint, group.stray);
  if (!strays.empty()) add_strays(sketch, strays, space, limbs);
  for (auto& limb : limbs) std::sort(limb.strokes.begin(), limb.strokes.end());
  return limbs;
}

}  // namespace inkflate
