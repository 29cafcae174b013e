// SPDX-License-Identifier: Apache-2.0
#include "io/fit_loop.h"

#include <algorithm>

#include "geometry/curve_fit.h"

namespace inkflate {
namespace {

constexpr double kSmoothTolerancePx = 0.6;
constexpr double kTightTolerancePx = 0.25;
// Passes of the average 1 2 1: enough for the stairs of pixels, and a circle of 20 px shrinks by less than 0.1 px.
constexpr int kSmoothPasses = 4;
// A corner turns by over 60 degrees between its sides, each so many pixels long.
constexpr int kSidePx = 7;
constexpr double kCornerCosine = 0.5;
// The direction at the end of a smooth chain is taken over so many pixels to both sides.
constexpr int kTangentPx = 4;

/// A loop with indices that run around it.
class Ring {
 public:
  explicit Ring(Contour points) : points_(std::move(points)) {}

  int count() const { return static_cast<int>(std::ssize(points_)); }
  int index(int i) const { return ((i % count()) + count()) % count(); }
  Vec2 operator[](int i) const { return points_[static_cast<std::size_t>(index(i))]; }

  /// The direction from one point to another; of the first step where both are the same.
  Vec2 direction(int from, int to) const {
    auto const d = (*this)[to] - (*this)[from];
    return normalized(d == Vec2{} ? (*this)[from + 1] - (*this)[from] : d);
  }

  void smooth(std::vector<bool> const& is_pinned) {
    for (int pass = 0; pass < kSmoothPasses; ++pass) {
      auto averaged = points_;
      for (int i = 0; i < count(); ++i) {
        auto const at = static_cast<std::size_t>(i);
        if (!is_pinned[at]) averaged[at] = ((*this)[i - 1] + points_[at] * 2 + (*this)[i + 1]) / 4;
      }
      points_ = std::move(averaged);
    }
  }

 private:
  Contour points_;
};

/// The sharpest point of each bend that is sharp enough.
std::vector<bool> find_corners(Ring const& ring) {
  int const count = ring.count();
  int const side = std::min(kSidePx, count / 6);
  std::vector<double> cosines(static_cast<std::size_t>(count), 1);
  for (int i = 0; side > 1 && i < count; ++i) {
    cosines[static_cast<std::size_t>(i)] =
        dot(ring.direction(i - side, i), ring.direction(i, i + side));
  }
  auto const cosine = [&](int i) { return cosines[static_cast<std::size_t>(ring.index(i))]; };
  std::vector<bool> is_corner(static_cast<std::size_t>(count), false);
  for (int i = 0; i < count; ++i) {
    bool is_sharpest = cosine(i) < kCornerCosine;
    for (int k = 1; k <= side && is_sharpest; ++k) {
      is_sharpest = cosine(i) <= cosine(i - k) && cosine(i) < cosine(i + k);
    }
    is_corner[static_cast<std::size_t>(i)] = is_sharpest;
  }
  return is_corner;
}

Outline steps(Contour const& loop, std::span<RunKind const> kinds) {
  Outline outline;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    outline.pieces.push_back({line_cubic(loop[i], loop[(i + 1) % loop.size()]), kinds[i]});
  }
  return outline;
}

/// Cuts where the kind changes and at corners; a loop without either anywhere.
std::vector<int> find_cuts(std::span<RunKind const> kinds, std::vector<bool> const& is_corner) {
  std::vector<int> cuts;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    bool const changes = kinds[i] != kinds[i == 0 ? kinds.size() - 1 : i - 1];
    if (changes || is_corner[i]) cuts.push_back(static_cast<int>(i));
  }
  if (cuts.empty()) cuts.push_back(0);
  return cuts;
}

}  // namespace

Outline fit_loop(Contour const& loop, std::span<RunKind const> kinds, LoopFit fit) {
  if (fit == LoopFit::Steps) return steps(loop, kinds);
  Ring ring(loop);
  auto const is_corner = find_corners(ring);
  if (fit == LoopFit::Smooth) ring.smooth(is_corner);
  auto const cuts = find_cuts(kinds, is_corner);
  double const tolerance_px = fit == LoopFit::Smooth ? kSmoothTolerancePx : kTightTolerancePx;
  Outline outline;
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    int const first = cuts[c];
    int const last = c + 1 < cuts.size() ? cuts[c + 1] : cuts[0] + ring.count();
    Polyline points;
    for (int i = first; i <= last; ++i) {
      if (points.empty() || points.back() != ring[i]) points.push_back(ring[i]);
    }
    if (points.size() < 2) continue;
    // Smooth ends get one direction for the chains on both sides.
    int const reach = std::min(kTangentPx, last - first);
    auto const is_sharp = [&](int i) { return is_corner[static_cast<std::size_t>(ring.index(i))]; };
    auto const start = ring.direction(is_sharp(first) ? first : first - kTangentPx,
                                      first + (is_sharp(first) ? reach : kTangentPx));
    auto const end = ring.direction(last - (is_sharp(last) ? reach : kTangentPx),
                                    is_sharp(last) ? last : last + kTangentPx);
    auto const kind = kinds[static_cast<std::size_t>(first)];
    for (auto const& piece : fit_cubics(points, start, end, tolerance_px)) {
      outline.pieces.push_back({piece.curve, kind});
    }
  }
  return outline;
}

}  // namespace inkflate
