// SPDX-License-Identifier: Apache-2.0
#include "simplify/fit_rim.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/curve_fit.h"
#include "simplify/rim_chains.h"
#include "simplify/smooth_contour.h"

namespace inkflate {
namespace {

// At smooth = 1: the curve may leave the centred rim by so much (work px), which is first averaged over so many corners.
constexpr double kTolerancePx = 2.0;
constexpr double kLeastTolerancePx = 0.2;
constexpr double kAverage = 4;

// The sides of a corner are taken as lines from here to there, work px: near the corner, overdrawn strokes overshoot or fall short.
constexpr double kSideFromPx = 5;
constexpr double kSideToPx = 18;
// No corner moves farther than this, work px.
constexpr double kMostCornerMovePx = 12;
// Sides that turn by less than 25 degrees do not say where they meet: |sin|.
constexpr double kLeastSideSine = 0.42;

// The direction at the end of a chain is taken over this length, work px: over less, one sample that is a little off tilts the curve.
constexpr double kEndReachPx = 12;
// A closing flows on only if it turns by less than 55 degrees at either end: cos.
constexpr double kLeastFlow = 0.57;

/// The points of a chain, and for each the rim corner it came from (counted along the chain).
struct ChainPoints {
  RunKind kind = RunKind::Ink;
  int first = 0;  // rim corner
  int size = 0;   // edges of the rim
  Polyline points;
  std::vector<int> steps;  // per point: edges from `first`
};

ChainPoints points_of(RimChain const& chain, Contour const& positions) {
  ChainPoints result = {chain.kind, chain.first, chain.size, {}, {}};
  int const count = static_cast<int>(std::ssize(positions));
  for (int k = 0; k <= chain.size; ++k) {
    auto const p = positions[(chain.first + k) % count];
    // Equal neighbours have no direction between them.
    if (!result.points.empty() && result.points.back() == p && k < chain.size) continue;
    result.points.push_back(p);
    result.steps.push_back(k);
  }
  auto const n = result.points.size();
  if (n > 2 && result.points[n - 2] == result.points[n - 1]) {
    result.points.erase(result.points.end() - 2);
    result.steps.erase(result.steps.end() - 2);
  }
  return result;
}

/// The index of the first point at least so far along the polyline, seen from its start (direction 1) or its end (-1).
int index_at(Polyline const& points, double along_px, int direction) {
  int const count = static_cast<int>(std::ssize(points));
  int i = direction > 0 ? 0 : count - 1;
  double passed = 0;
  while (i + direction >= 0 && i + direction < count && passed < along_px) {
    passed += distance(points[i], points[i + direction]);
    i += direction;
  }
  return i;
}

/// Where the lines a0 a1 and b0 b1 meet, if they turn enough to tell.
std::optional<Vec2> meeting_point(Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1) {
  auto const a = normalized(a1 - a0);
  auto const b = normalized(b1 - b0);
  double const sine = cross(a, b);
  if (std::abs(sine) < kLeastSideSine) return std::nullopt;
  return a0 + a * (cross(b0 - a0, b) / sine);
}

/// Drops the inner points within a distance of the chain's start or end.
void trim(ChainPoints& chain, double from_start_px, double from_end_px) {
  int const count = static_cast<int>(std::ssize(chain.points));
  int const low = from_start_px > 0 ? index_at(chain.points, from_start_px, 1) : 1;
  int const high = from_end_px > 0 ? index_at(chain.points, from_end_px, -1) : count - 2;
  ChainPoints kept = {chain.kind, chain.first, chain.size, {}, {}};
  for (int i = 0; i < count; ++i) {
    if (i != 0 && i != count - 1 && (i < low || i > high)) continue;
    kept.points.push_back(chain.points[i]);
    kept.steps.push_back(chain.steps[i]);
  }
  chain = std::move(kept);
}

/// Puts the corner between two chains where their sides meet: overdrawn corners are rounded and the rim there runs along overshoots.
void sharpen_corner(ChainPoints& before, ChainPoints& after) {
  if (before.kind == RunKind::Closing || after.kind == RunKind::Closing) return;
  auto const& a = before.points;
  auto const& b = after.points;
  if (length(a) < 2 * kSideToPx || length(b) < 2 * kSideToPx) return;
  auto const corner = meeting_point(a[index_at(a, kSideToPx, -1)], a[index_at(a, kSideFromPx, -1)],
                                    b[index_at(b, kSideFromPx, 1)], b[index_at(b, kSideToPx, 1)]);
  if (!corner || distance(*corner, b.front()) > kMostCornerMovePx) return;
  trim(before, 0, kSideFromPx);
  trim(after, kSideFromPx, 0);
  before.points.back() = *corner;
  after.points.front() = *corner;
}

/// Averages without shrinking bends: what one pass takes away is smoothed as well and given back.
template <typename Smooth>
void smooth_twice(Polyline& points, Smooth smooth) {
  auto once = points;
  smooth(once);
  for (int i = 0; i < std::ssize(points); ++i) points[i] -= once[i];
  smooth(points);
  for (int i = 0; i < std::ssize(points); ++i) points[i] += once[i];
}

/// Collects the pieces of an outline and where each rim corner lies on it.
class OutlineBuilder {
 public:
  explicit OutlineBuilder(Rim const& rim) : rim_(&rim), parameters_(rim.size(), 0) {}

  void add(ChainPoints const& chain, std::vector<FittedCubic> const& fitted) {
    place_corners(chain, fitted);
    for (auto const& piece : fitted) outline_.pieces.push_back({piece.curve, chain.kind});
    for (int k = 0; k < chain.size; ++k)
      edges_.push_back({(chain.first + k) % count(), chain.kind});
  }

  Outline finish(StrokeSamples const& samples) {
    add_sources(samples);
    return std::move(outline_);
  }

 private:
  struct EdgeOfKind {
    int corner;
    RunKind kind;
  };

  int count() const { return static_cast<int>(std::ssize(*rim_)); }

  /// A corner's parameter: its piece, and the share of the piece's points before it. Dropped points go with their neighbours.
  void place_corners(ChainPoints const& chain, std::vector<FittedCubic> const& fitted) {
    int const base = static_cast<int>(std::ssize(outline_.pieces));
    for (int f = 0; f < std::ssize(fitted); ++f) {
      auto const& piece = fitted[f];
      int const from = chain.steps[piece.first];
      int const to = chain.steps[piece.last];
      for (int k = from; k < to; ++k) {
        parameters_[(chain.first + k) % count()] =
            base + f + static_cast<double>(k - from) / (to - from);
      }
    }
  }

  void add_sources(StrokeSamples const& samples) {
    double const end = static_cast<double>(std::ssize(outline_.pieces));
    for (int e = 0; e < std::ssize(edges_); ++e) {
      if (edges_[e].kind == RunKind::Closing) continue;
      bool const is_last = e + 1 == std::ssize(edges_);
      auto const& from = samples.points[(*rim_)[edges_[e].corner].sample];
      auto const& to =
          samples.points[(*rim_)[is_last ? edges_[0].corner : edges_[e + 1].corner].sample];
      if (from.stroke != to.stroke) continue;
      double const from_parameter = parameters_[edges_[e].corner];
      double const to_parameter = is_last ? end : parameters_[edges_[e + 1].corner];
      auto& sources = outline_.sources;
      if (!sources.empty() && sources.back().stroke == from.stroke &&
          sources.back().to == from_parameter) {
        sources.back().to = to_parameter;
        sources.back().sample_to = to.along;
      } else {
        sources.push_back({from_parameter, to_parameter, from.stroke, from.along, to.along});
      }
    }
  }

  Rim const* rim_;
  std::vector<double> parameters_;
  std::vector<EdgeOfKind> edges_;  // in outline order
  Outline outline_;
};

std::vector<FittedCubic> straight_pieces(Polyline const& points) {
  std::vector<FittedCubic> pieces;
  for (int i = 0; i + 1 < std::ssize(points); ++i) {
    pieces.push_back({line_cubic(points[i], points[i + 1]), i, i + 1});
  }
  return pieces;
}

/// A curve across a gap that leaves and arrives in the direction of the strokes; none where they do not face each other.
std::optional<Cubic> flowing_closing(Polyline const& before, Polyline const& gap,
                                     Polyline const& after) {
  auto const from = gap.front();
  auto const to = gap.back();
  auto const chord = normalized(to - from);
  auto const leaving = normalized(from - before[index_at(before, kEndReachPx, -1)]);
  auto const arriving = normalized(after[index_at(after, kEndReachPx, 1)] - to);
  if (dot(chord, leaving) < kLeastFlow || dot(chord, arriving) < kLeastFlow) return std::nullopt;
  double const handle = distance(from, to) / 3;
  return Cubic{{from, from + leaving * handle, to - arriving * handle, to}};
}

/// Smooths a chain and gives the tangents at its ends.
std::vector<FittedCubic> fit_ink(ChainPoints& chain, bool closed, FitOptions const& options) {
  auto& points = chain.points;
  int const radius = static_cast<int>(options.smooth * kAverage + 0.5);
  double const tolerance = std::max(kLeastTolerancePx, options.smooth * kTolerancePx);
  Vec2 start;
  Vec2 end;
  if (closed) {
    points.pop_back();
    smooth_twice(points, [&](Polyline& p) { smooth_closed(p, radius); });
    start = normalized(points[1] - points.back());
    end = start;
    points.push_back(points.front());
  } else {
    smooth_twice(points, [&](Polyline& p) { smooth_open(p, radius); });
    if (auto const one = fit_one_cubic(points, tolerance)) {
      return {{*one, 0, static_cast<int>(std::ssize(points)) - 1}};
    }
    auto const near_start = points[index_at(points, kEndReachPx, 1)];
    auto const near_end = points[index_at(points, kEndReachPx, -1)];
    start = normalized(near_start - points.front());
    end = normalized(points.back() - near_end);
  }
  return fit_cubics(points, start, end, tolerance);
}

}  // namespace

Outline fit_rim(Rim const& rim, Contour const& positions, StrokeSamples const& samples,
                FitOptions const& options) {
  auto const cut = cut_rim(rim, positions);
  std::vector<ChainPoints> chains;
  for (auto const& chain : cut) chains.push_back(points_of(chain, positions));
  int const count = static_cast<int>(std::ssize(chains));
  bool const closed = cut[0].is_ring && chains[0].points.size() > 2;
  for (int c = 0; c < count && count > 1; ++c)
    sharpen_corner(chains[(c + count - 1) % count], chains[c]);
  std::vector<std::vector<FittedCubic>> fitted(chains.size());
  for (int c = 0; c < count; ++c) {
    auto& chain = chains[c];
    fitted[c] = chain.kind == RunKind::Closing ? straight_pieces(chain.points)
                                               : fit_ink(chain, closed, options);
  }
  OutlineBuilder builder(rim);
  for (int c = 0; c < count; ++c) {
    auto const& chain = chains[c];
    auto const& before = chains[(c + count - 1) % count];
    auto const& after = chains[(c + 1) % count];
    bool const may_flow = options.closing == ClosingShape::Flowing &&
                          chain.kind == RunKind::Closing && fitted[c].size() == 1 &&
                          before.kind != RunKind::Closing && after.kind != RunKind::Closing;
    if (may_flow) {
      if (auto const curve = flowing_closing(before.points, chain.points, after.points)) {
        fitted[c][0].curve = *curve;
      }
    }
    builder.add(chain, fitted[c]);
  }
  return builder.finish(samples);
}

Outline straight_outline(Rim const& rim, StrokeSamples const& samples) {
  auto const points = positions(rim, samples);
  int const count = static_cast<int>(std::ssize(rim));
  OutlineBuilder builder(rim);
  for (int i = 0; i < count; ++i) {
    ChainPoints const edge = {rim[i].to_next, i, 1, {points[i], points[(i + 1) % count]}, {0, 1}};
    builder.add(edge, straight_pieces(edge.points));
  }
  return builder.finish(samples);
}

}  // namespace inkflate
