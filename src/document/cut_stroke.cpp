// SPDX-License-Identifier: Apache-2.0
#include "document/cut_stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace inkflate {
namespace {

/// Shorter pieces would be dots that nobody has drawn.
constexpr double kLeastPiecePx = 0.5;
/// Of the radius, for small erasers; in px for others. Far above rounding at 1e6 px, far below what can be seen.
constexpr double kTolerance = 1e-6;

Rect box_of(Vec2 a, Vec2 b) {
  Rect box;
  box.include(a);
  box.include(b);
  return box;
}

Sample between(Sample const& a, Sample const& b, double t) {
  if (t <= 0) return a;
  if (t >= 1) return b;
  return {lerp(a.position, b.position, t), a.pressure + (b.pressure - a.pressure) * t,
          a.time_s + (b.time_s - a.time_s) * t};
}

/// Gathers what remains of a stroke, sample by sample.
class Pieces {
 public:
  explicit Pieces(Stroke const& stroke) : look_(stroke) { look_.samples.clear(); }

  bool is_open() const { return !samples_.empty(); }
  void add(Sample const& sample) { samples_.push_back(sample); }

  void close() {
    auto samples = std::exchange(samples_, {});
    double length_px = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      length_px += distance(samples[i - 1].position, samples[i].position);
    }
    if (length_px < kLeastPiecePx) return;
    // Where time was not recorded all are 0 and stay so. It may have run backwards.
    double const start_s = samples.front().time_s;
    for (auto& sample : samples) sample.time_s = std::max(0.0, sample.time_s - start_s);
    pieces_.push_back(look_);
    pieces_.back().samples = std::move(samples);
  }

  std::vector<Stroke> take() && { return std::move(pieces_); }

 private:
  Stroke look_;  // without samples
  std::vector<Sample> samples_;
  std::vector<Stroke> pieces_;
};

}  // namespace

Swept::Swept(Polyline path, double radius_px)
    : box_(bounds(path).grown(radius_px)),
      radius_px_(radius_px),
      tolerance_px_(kTolerance * std::min(1.0, radius_px)) {
  if (path.size() == 1) path.push_back(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    capsules_.push_back({path[i - 1], path[i], box_of(path[i - 1], path[i]).grown(radius_px)});
  }
}

bool Swept::may_meet(Rect const& box) const { return touch(box, box_); }

/// A capsule is convex, so a line crosses it in one stretch: from where it enters the first of the two discs and the
/// rectangle between them to where it leaves the last.
Swept::Stretch Swept::within(Capsule const& capsule, Vec2 a, Vec2 b) const {
  Vec2 const step = b - a;
  double const length_px = norm(step);
  Stretch whole = {1, 0};
  auto const include = [&](double from, double to) {
    if (from < to) whole = {std::min(whole.from, from), std::max(whole.to, to)};
  };
  for (auto const centre : {capsule.from, capsule.to}) {
    // From the nearest point to both sides: more exact than the quadratic equation.
    double const nearest = dot(centre - a, step) / (length_px * length_px);
    double const away = radius_px_ * radius_px_ - squared_norm(a + step * nearest - centre);
    if (!(away > 0)) continue;
    double const half = std::sqrt(away) / length_px;
    include(std::max(0.0, nearest - half), std::min(1.0, nearest + half));
  }
  double const side_px = distance(capsule.from, capsule.to);
  if (side_px > 0) {
    Vec2 const along = (capsule.to - capsule.from) / side_px;
    double from = 0;
    double to = 1;
    auto const clip = [&](double start, double slope, double least, double most) {
      if (slope == 0) {
        if (start < least || start > most) to = from;
        return;
      }
      double const enters = ((slope > 0 ? least : most) - start) / slope;
      double const leaves = ((slope > 0 ? most : least) - start) / slope;
      from = std::max(from, enters);
      to = std::min(to, leaves);
    };
    clip(dot(a - capsule.from, along), dot(step, along), 0, side_px);
    clip(cross(along, a - capsule.from), cross(along, step), -radius_px_, radius_px_);
    include(from, to);
  }
  return whole;
}

std::vector<Swept::Capsule> Swept::capsules_near(Rect const& box) const {
  std::vector<Capsule> near;
  for (auto const& capsule : capsules_) {
    if (touch(box, capsule.box)) near.push_back(capsule);
  }
  return near;
}

bool Swept::covers(std::vector<Capsule> const& capsules, Vec2 p) const {
  double const reach_px = radius_px_ - tolerance_px_;
  return std::any_of(capsules.begin(), capsules.end(), [&](Capsule const& capsule) {
    return squared_distance_to_segment(p, capsule.from, capsule.to) < reach_px * reach_px;
  });
}

std::vector<Swept::Stretch> Swept::erased(std::vector<Capsule> const& capsules, Vec2 a,
                                          Vec2 b) const {
  Rect const box = box_of(a, b);
  std::vector<Stretch> found;
  double const length_px = distance(a, b);
  if (length_px * length_px == 0) {
    if (covers(capsules, a)) found.push_back({0, 1});
    return found;
  }
  for (auto const& capsule : capsules) {
    if (!touch(box, capsule.box)) continue;
    auto const stretch = within(capsule, a, b);
    bool const is_whole = stretch.from <= 0 && stretch.to >= 1;
    if (is_whole || (stretch.to - stretch.from) * length_px > tolerance_px_) {
      found.push_back(stretch);
    }
  }
  std::sort(found.begin(), found.end(),
            [](Stretch const& s, Stretch const& t) { return s.from < t.from; });
  std::vector<Stretch> apart;
  for (auto const& stretch : found) {
    if (!apart.empty() && stretch.from <= apart.back().to) {
      apart.back().to = std::max(apart.back().to, stretch.to);
    } else {
      apart.push_back(stretch);
    }
  }
  return apart;
}

std::optional<std::vector<Stroke>> Swept::cut(Stroke const& stroke) const {
  auto const& samples = stroke.samples;
  Rect box;
  for (auto const& sample : samples) box.include(sample.position);
  auto const near = capsules_near(box);
  if (near.empty()) return {};
  if (samples.size() == 1) {
    if (!covers(near, samples.front().position)) return {};
    return std::vector<Stroke>{};
  }
  Pieces pieces(stroke);
  bool is_met = false;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    auto const& a = samples[i - 1];
    auto const& b = samples[i];
    double done = 0;
    for (auto const& gone : erased(near, a.position, b.position)) {
      is_met = true;
      if (gone.from > done) {
        if (!pieces.is_open()) pieces.add(between(a, b, done));
        pieces.add(between(a, b, gone.from));
      }
      pieces.close();
      done = gone.to;
    }
    if (done >= 1) continue;
    if (!pieces.is_open()) pieces.add(between(a, b, done));
    pieces.add(b);
  }
  pieces.close();
  if (!is_met) return {};
  return std::move(pieces).take();
}

}  // namespace inkflate
