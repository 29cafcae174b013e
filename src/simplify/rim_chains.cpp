// SPDX-License-Identifier: Apache-2.0
#include "simplify/rim_chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace inkflate {
namespace {

// A run shorter than this says nothing of its own, work px: about the width of a pencil line that was drawn three times.
constexpr double kLeastRunPx = 7;

// A corner is a turn of more than 50 degrees between chords of this length, work px ...
constexpr double kChordPx = 14;
constexpr double kCornerCosine = 0.64;
// ... most of which happens within shorter chords: else it is a bend. A circle turns by half there.
constexpr double kShortChordPx = 7;
constexpr double kShortCosine = 0.80;

// A jump from one of several overdrawn strokes to the next, work px: no longer than this along the rim, and no other corner nearer
// than that, or it is a feature of the drawing: a tooth, a step.
constexpr double kJumpPx = 16;
constexpr double kAlonePx = 28;

// The outline goes on when it turns by less than 45 degrees in all; the way aside is more than 37 degrees off: cos.
constexpr double kGoesOn = 0.7;
constexpr double kAside = 0.8;

struct KindRun {
  int first;
  int size;
  RunKind kind;
  double length_px;
};

std::vector<KindRun> kind_runs(std::vector<RunKind> const& kinds, Contour const& positions) {
  int const count = static_cast<int>(std::ssize(kinds));
  int first = 0;
  while (first < count && kinds[first] == kinds[(first + count - 1) % count]) ++first;
  if (first == count) return {{0, count, kinds[0], perimeter(positions)}};
  std::vector<KindRun> runs;
  for (int k = 0; k < count; ++k) {
    int const i = (first + k) % count;
    if (runs.empty() || runs.back().kind != kinds[i]) runs.push_back({i, 0, kinds[i], 0});
    ++runs.back().size;
    runs.back().length_px += distance(positions[i], positions[(i + 1) % count]);
  }
  return runs;
}

/// Walks along a closed polyline by arc length.
class ArcWalk {
 public:
  explicit ArcWalk(Contour const& points)
      : points_(points), count_(static_cast<int>(std::ssize(points))) {
    sums_.assign(points.size() + 1, 0);
    for (int i = 0; i < count_; ++i) {
      sums_[i + 1] = sums_[i] + distance(points[i], points[(i + 1) % count_]);
    }
  }

  double total() const { return sums_[count_]; }
  double at(int i) const { return sums_[i]; }

  /// The point at an arc length, which may run past either end of the list.
  Vec2 point(double s) const {
    s -= std::floor(s / total()) * total();
    auto const next = std::upper_bound(sums_.begin(), sums_.end(), s);
    int const i = std::clamp(static_cast<int>(next - sums_.begin()) - 1, 0, count_ - 1);
    double const size = sums_[i + 1] - sums_[i];
    return lerp(points_[i], points_[(i + 1) % count_],
                size > 0 ? std::min(1.0, (s - sums_[i]) / size) : 0);
  }

 private:
  Contour const& points_;
  int count_;
  std::vector<double> sums_;
};

/// The cosine of the turn at corner i between the chords of a length on both sides.
double turn_cosine(ArcWalk const& walk, Contour const& positions, int i, double chord_px) {
  auto const in = positions[i] - walk.point(walk.at(i) - chord_px);
  auto const out = walk.point(walk.at(i) + chord_px) - positions[i];
  double const size = norm(in) * norm(out);
  return size > 0 ? dot(in, out) / size : 1;
}

/// Whether a gap leads aside, from the end of one overdrawn stroke to the next one beside it, and the outline goes on as before.
bool is_sidestep(KindRun const& gap, ArcWalk const& walk, Contour const& positions) {
  if (gap.length_px >= kJumpPx) return false;
  int const count = static_cast<int>(std::ssize(positions));
  auto const from = positions[gap.first];
  auto const to = positions[(gap.first + gap.size) % count];
  auto const before = normalized(from - walk.point(walk.at(gap.first) - kChordPx));
  auto const after =
      normalized(walk.point(walk.at((gap.first + gap.size) % count) + kChordPx) - to);
  return dot(before, after) > kGoesOn && dot(normalized(to - from), before + after) < 2 * kAside;
}

/// Whether a short run stands for nothing, and for which kind it gives way.
RunKind effective_kind(std::vector<KindRun> const& runs, int r, ArcWalk const& walk,
                       Contour const& positions) {
  int const count = static_cast<int>(std::ssize(runs));
  auto const& run = runs[r];
  if (count == 1) return run.kind;
  if (run.kind == RunKind::Closing && is_sidestep(run, walk, positions)) return RunKind::Ink;
  if (run.length_px >= kLeastRunPx) return run.kind;
  auto const before = runs[(r + count - 1) % count].kind;
  auto const after = runs[(r + 1) % count].kind;
  if (before == after) return before;
  return run.kind == RunKind::Closing ? RunKind::Ink : run.kind;
}

/// Runs too short to mean anything take the kind of what is around them.
void settle(std::vector<RunKind>& kinds, ArcWalk const& walk, Contour const& positions) {
  int const count = static_cast<int>(std::ssize(kinds));
  // First gaps within the pencil's width, for the two sides of such a gap may be short as well.
  for (auto const shortest_first : {RunKind::Closing, RunKind::HelpLine, RunKind::Ink}) {
    auto const runs = kind_runs(kinds, positions);
    for (int r = 0; r < std::ssize(runs); ++r) {
      if (runs[r].kind != shortest_first) continue;
      auto const kind = effective_kind(runs, r, walk, positions);
      for (int k = 0; k < runs[r].size; ++k) kinds[(runs[r].first + k) % count] = kind;
    }
  }
}

/// The sharpest place of every stretch of the rim that turns like a corner, in rim order.
std::vector<int> find_corners(ArcWalk const& walk, Contour const& positions) {
  int const count = static_cast<int>(std::ssize(positions));
  std::vector<double> cosines(positions.size(), 1);
  if (walk.total() > 4 * kChordPx) {
    for (int i = 0; i < count; ++i) cosines[i] = turn_cosine(walk, positions, i, kChordPx);
  }
  std::vector<int> corners;
  for (int i = 0; i < count; ++i) {
    if (cosines[i] > kCornerCosine) continue;
    bool is_sharpest = true;
    for (int const side : {-1, 1}) {
      double passed = 0;
      for (int k = i; is_sharpest;) {
        int const next = (k + side + count) % count;
        passed += distance(positions[k], positions[next]);
        k = next;
        if (passed > kChordPx || k == i) break;
        is_sharpest = cosines[i] < cosines[k] || (cosines[i] == cosines[k] && i < k);
      }
    }
    if (is_sharpest && turn_cosine(walk, positions, i, kShortChordPx) < kShortCosine) {
      corners.push_back(i);
    }
  }
  return corners;
}

/// Takes out the corners of jumps: two that turn opposite ways, close together and alone. What lies between them is ink.
std::vector<int> without_jumps(std::vector<int> const& corners, ArcWalk const& walk,
                               Contour const& positions, std::vector<RunKind>& kinds) {
  int const count = static_cast<int>(std::ssize(corners));
  if (count < 2) return corners;
  auto const ahead_px = [&](int c) {
    double const gap = walk.at(corners[(c + 1) % count]) - walk.at(corners[c % count]);
    return gap >= 0 ? gap : gap + walk.total();
  };
  auto const turn = [&](int c) {
    auto const at = positions[corners[c]];
    return cross(at - walk.point(walk.at(corners[c]) - kChordPx),
                 walk.point(walk.at(corners[c]) + kChordPx) - at);
  };
  std::vector<std::uint8_t> is_jump(corners.size(), 0);
  for (int c = 0; c < count; ++c) {
    int const next = (c + 1) % count;
    bool const is_alone =
        count == 2 || (ahead_px((c + count - 1) % count) > kAlonePx && ahead_px(next) > kAlonePx);
    if (ahead_px(c) > kJumpPx || !is_alone || turn(c) * turn(next) >= 0) continue;
    is_jump[c] = 1;
    is_jump[next] = 1;
    int const rim_count = static_cast<int>(std::ssize(kinds));
    for (int i = corners[c]; i != corners[next]; i = (i + 1) % rim_count) kinds[i] = RunKind::Ink;
  }
  std::vector<int> kept;
  for (int c = 0; c < count; ++c) {
    if (is_jump[c] == 0) kept.push_back(corners[c]);
  }
  return kept;
}

}  // namespace

std::vector<RimChain> cut_rim(Rim const& rim, Contour const& positions) {
  int const count = static_cast<int>(std::ssize(rim));
  std::vector<RunKind> kinds;
  kinds.reserve(rim.size());
  for (auto const& point : rim) kinds.push_back(point.to_next);
  ArcWalk const walk(positions);
  auto const corners = without_jumps(find_corners(walk, positions), walk, positions, kinds);
  settle(kinds, walk, positions);
  std::vector<std::uint8_t> is_corner(rim.size(), 0);
  for (int const corner : corners) is_corner[corner] = 1;
  auto const is_break = [&](int i) {
    return is_corner[i] != 0 || kinds[i] != kinds[(i + count - 1) % count];
  };
  int first = 0;
  while (first < count && !is_break(first)) ++first;
  if (first == count) return {{0, count, kinds[0], true}};
  std::vector<RimChain> chains;
  for (int k = 0; k < count; ++k) {
    int const i = (first + k) % count;
    if (is_break(i)) chains.push_back({i, 0, kinds[i], false});
    ++chains.back().size;
  }
  return chains;
}

}  // namespace inkflate
