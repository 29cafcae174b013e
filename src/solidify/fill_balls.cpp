// SPDX-License-Identifier: Apache-2.0
#include "solidify/fill_balls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace inkflate {
namespace {

// Two faces bound a thin place if they look apart by this much: up to a wedge of 66 degrees it counts in full, from 78 on it is an
// edge that is meant.
constexpr double kOpposedInFull = 0.4;
constexpr double kOpposed = 0.2;
// A chord this oblique to the faces says little about what lies between them. Of the seven directions one is always within 36 degrees.
constexpr double kLeastSlope = 0.5;
// Slits narrower than this are closed, or the lattice would leave tunnels in them; lattice units.
constexpr double kSlit = 2;
constexpr double kSlitOverlap = 0.7;
// One ball is kept in each cell of this size. Wider cells, with dents between the balls, come only when there are very many balls.
constexpr double kLeastCell = 0.25;
constexpr std::size_t kMostFound = 2'000'000;
constexpr double kMostWork = 1e8;

/// One end of a chord and the way its face looks, away from the chord.
struct Face {
  Vec3 place;
  Vec3 normal;
  int triangle = 0;
};

/// The radius of the ball that touches both faces from within, one of them at `a`.
double touching_radius(Face const& a, Face const& b) {
  return dot(b.place - a.place, b.normal) / (1 - dot(a.normal, b.normal));
}

/// 0 .. 1: how much two faces are the two sides of one sheet.
double opposition(Face const& a, Face const& b) {
  double const share = (-dot(a.normal, b.normal) - kOpposed) / (kOpposedInFull - kOpposed);
  return std::clamp(share, 0.0, 1.0);
}

bool is_steep(Face const& a, Face const& b, Vec3 direction) {
  return std::abs(dot(a.normal, direction)) >= kLeastSlope &&
         std::abs(dot(b.normal, direction)) >= kLeastSlope;
}

class Collector {
 public:
  Collector(LatticeMesh const& mesh, double least) : mesh_(mesh), least_(least) {}

  void add_line(LineSpans const& family, int line) {
    auto const crossings = family.crossings(line);
    for (int c = 0; c + 1 < std::ssize(crossings); ++c) {
      double const length = (crossings[c + 1].at - crossings[c].at) * unit_of(family);
      bool const is_chord = c % 2 == 0;
      // An oblique chord is longer than the place is thick.
      if (length > (is_chord ? least_ : kSlit) / kLeastSlope) continue;
      if (crossings[c].triangle < 0 || crossings[c + 1].triangle < 0) continue;
      add_pair(family, line, crossings[c], crossings[c + 1], is_chord ? 1 : -1);
    }
  }

  std::vector<Ball> take() {
    thin_out();
    while (work() > kMostWork) widen();
    std::vector<Ball> balls;
    for (auto const& found : found_) balls.push_back(found.ball);
    return balls;
  }

 private:
  struct Found {
    std::int64_t cell = 0;
    Ball ball;
  };

  std::int64_t cell_of(Vec3 centre) const {
    auto const whole = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    constexpr std::int64_t range = 1 << 20;
    return (whole(centre.z) * range + whole(centre.y)) * range + whole(centre.x);
  }

  /// Leaves the largest ball of each cell.
  void thin_out() {
    for (auto& found : found_) found.cell = cell_of(found.ball.centre);
    std::sort(found_.begin(), found_.end(), [](Found const& a, Found const& b) {
      auto const key = [](Found const& f) {
        return std::tuple(f.cell, -f.ball.radius, f.ball.centre.x, f.ball.centre.y, f.ball.centre.z,
                          f.ball.triangle);
      };
      return key(a) < key(b);
    });
    auto const last = std::unique(found_.begin(), found_.end(),
                                  [](Found const& a, Found const& b) { return a.cell == b.cell; });
    found_.erase(last, found_.end());
  }

  void widen() {
    cell_ *= 1.4;
    thin_out();
  }

  /// How many nodes the balls hold, about.
  double work() const {
    double sum = 0;
    for (auto const& [cell, ball] : found_) {
      double const radius = ball.radius + 1;
      sum += radius * radius * radius;
    }
    return sum;
  }

  static double unit_of(LineSpans const& family) {
    return step_length(family.direction()) == kLongStep ? 1 : kShortStep;
  }

  void add_pair(LineSpans const& family, int line, LineCrossing const& from, LineCrossing const& to,
                double sign) {
    Face const a{family.place(line, from.at), sign * mesh_.normal(from.triangle), from.triangle};
    Face const b{family.place(line, to.at), sign * mesh_.normal(to.triangle), to.triangle};
    double const weight = opposition(a, b);
    if (weight <= 0 || !is_steep(a, b, normalized(place_of(kSteps[family.direction()])))) return;
    add_ball(a, touching_radius(a, b), weight, sign > 0);
    add_ball(b, touching_radius(b, a), weight, sign > 0);
  }

  void add_ball(Face const& face, double radius, double weight, bool is_solid) {
    double const most = (is_solid ? least_ : kSlit) / 2;
    if (!(radius >= 0) || radius >= most) return;
    double const wanted =
        is_solid ? most : radius + kSlitOverlap * std::min(1.0, 2 * (1 - radius / most));
    Ball const ball{face.place - face.normal * radius, radius + weight * (wanted - radius),
                    face.triangle};
    found_.push_back({0, ball});
    if (found_.size() < kMostFound) return;
    thin_out();
    while (found_.size() > kMostFound / 2) widen();
  }

  LatticeMesh const& mesh_;
  double least_ = 0;
  double cell_ = kLeastCell;
  std::vector<Found> found_;
};

}  // namespace

std::vector<Ball> fill_balls(LatticeMesh const& mesh, std::span<LineSpans const> families,
                             double least) {
  Collector collector(mesh, least);
  for (auto const& family : families) {
    for (int l = 0; l < family.line_count(); ++l) collector.add_line(family, l);
  }
  return collector.take();
}

}  // namespace inkflate
