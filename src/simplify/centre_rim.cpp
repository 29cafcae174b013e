// SPDX-License-Identifier: Apache-2.0
#include "simplify/centre_rim.h"

#include <algorithm>
#include <cmath>

#include "simplify/smooth_contour.h"

namespace inkflate {
namespace {

// The rim's direction is taken over this many corners to each side: past the zigzag between overdrawn strokes.
constexpr int kTangentReach = 4;

// Strokes are compared within this distance along the rim, work px: about four samples of each stroke.
constexpr double kWindowPx = 4;

// cos 25 degrees, squared: a stroke that deviates more runs across the outline, not along it.
constexpr double kParallel = 0.82;

// Of the width at a thin place: both sides may move and must not meet.
constexpr double kMostOfWidth = 1.0 / 3;

// Moves are averaged over about this many corners to each side: some 9 work px.
constexpr int kEvenOut = 4;

struct RimGeometry {
  Contour points;
  std::vector<Vec2> tangents;
};

RimGeometry measure(Rim const& rim, StrokeSamples const& samples) {
  RimGeometry geometry = {positions(rim, samples), {}};
  int const count = static_cast<int>(std::ssize(rim));
  int const reach = std::min(kTangentReach, (count - 1) / 2);
  geometry.tangents.reserve(rim.size());
  for (int i = 0; i < count; ++i) {
    geometry.tangents.push_back(normalized(geometry.points[(i + reach) % count] -
                                           geometry.points[(i + count - reach) % count]));
  }
  return geometry;
}

/// How far a corner may move inside: its reach, or less where the other side is near.
std::vector<double> limits(RimGeometry const& geometry, double reach_px) {
  double const look_px = reach_px / kMostOfWidth;
  PointGrid const grid(geometry.points, reach_px);
  std::vector<double> result(geometry.points.size());
  for (int i = 0; i < std::ssize(result); ++i) {
    auto const at = geometry.points[i];
    auto const tangent = geometry.tangents[i];
    double nearest = look_px * look_px;
    grid.near(at, look_px, [&](int j) {
      auto const across = geometry.points[j] - at;
      double const squared = squared_norm(across);
      if (squared < nearest && cross(tangent, across) > 0 &&
          dot(tangent, geometry.tangents[j]) < 0) {
        nearest = squared;
      }
    });
    result[i] = std::sqrt(nearest) * kMostOfWidth;
  }
  return result;
}

/// The mean of the offsets that hang together with 0: as many votes as samples, so each pass of the pen counts by its length.
double middle(std::vector<double>& offsets, double gap_px) {
  std::sort(offsets.begin(), offsets.end());
  double sum = 0;
  double last = 0;
  int count = 0;
  for (double const offset : offsets) {
    if (offset - last > gap_px) break;
    sum += offset;
    last = std::max(offset, 0.0);
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

Contour centre_rim(Rim const& rim, StrokeSamples const& samples, PointGrid const& grid,
                   CentreOptions const& options) {
  auto const geometry = measure(rim, samples);
  auto const limit = limits(geometry, options.reach_px);
  std::vector<double> moves(rim.size());
  std::vector<double> offsets;
  for (int i = 0; i < std::ssize(rim); ++i) {
    auto const at = geometry.points[i];
    auto const tangent = geometry.tangents[i];
    offsets.clear();
    grid.near(at + perpendicular(tangent) * (limit[i] / 2), limit[i] / 2 + kWindowPx, [&](int k) {
      auto const& sample = samples.points[k];
      auto const off = sample.position - at;
      if (std::abs(dot(off, tangent)) > kWindowPx) return;
      double const inwards = cross(tangent, off);
      if (inwards < -kWindowPx || inwards > limit[i]) return;
      double const along = dot(sample.direction, tangent);
      if (along * along >= kParallel) offsets.push_back(inwards);
    });
    moves[i] = std::clamp(middle(offsets, options.gap_px), -kWindowPx, limit[i]);
  }
  smooth_closed(moves, kEvenOut);
  Contour result(rim.size());
  for (int i = 0; i < std::ssize(rim); ++i) {
    result[i] = geometry.points[i] + perpendicular(geometry.tangents[i]) * moves[i];
  }
  return result;
}

}  // namespace inkflate
