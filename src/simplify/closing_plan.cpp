// SPDX-License-Identifier: Apache-2.0
#include "simplify/closing_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "simplify/faint_strokes.h"

namespace inkflate {
namespace {

constexpr double kLargestCoordinatePx = 1e6;

// The longer side of the strokes is at least this share of their coordinates. Rounding to doubles is then 2e-5 work px and less, far
// below what keeps outlines from crossing.
constexpr double kLeastSize = 1e-8;

std::optional<Error> check(SimplifyOptions const& options) {
  if (options.gap_px && !(*options.gap_px > 0 && std::isfinite(*options.gap_px))) {
    return Error{ErrorCode::BadOption, "gap must be a length above 0 px, or auto"};
  }
  if (options.gap_px && options.method == SimplifyMethod::Grid) {
    return Error{ErrorCode::BadOption,
                 "method grid closes gaps by its energy alone; use method cut to limit them"};
  }
  if (!(options.smooth >= 0 && options.smooth <= 1)) {
    return Error{ErrorCode::BadOption, "smooth must lie between 0 and 1"};
  }
  for (auto const* marks : {&options.outside, &options.inside}) {
    for (auto const mark : *marks) {
      if (!is_finite(mark)) return Error{ErrorCode::BadOption, "a mark must be two finite numbers"};
    }
  }
  return std::nullopt;
}

std::optional<Error> check(Sketch const& sketch) {
  for (int i = 0; i < std::ssize(sketch.strokes); ++i) {
    if (sketch.strokes[i].group >= std::ssize(sketch.groups)) {
      return Error{ErrorCode::BadInput,
                   "stroke " + std::to_string(i) + " is in a group that does not exist", i};
    }
    for (auto const& sample : sketch.strokes[i].samples) {
      auto const p = sample.position;
      if (std::abs(p.x) <= kLargestCoordinatePx && std::abs(p.y) <= kLargestCoordinatePx) continue;
      return Error{
          ErrorCode::BadInput,
          "stroke " + std::to_string(i) + " has a coordinate that is not a number within 1e6 px",
          i};
    }
  }
  return std::nullopt;
}

Rect bounds_of(Sketch const& sketch) {
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  return box;
}

/// Strokes so small for where they lie that doubles cannot hold their outline.
std::optional<Error> check(Rect const& box) {
  if (box.is_empty() || box.longer_side() == 0) return std::nullopt;
  double const farthest_px = std::max(
      {std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
  if (box.longer_side() >= kLeastSize * farthest_px) return std::nullopt;
  return Error{ErrorCode::BadInput,
               "the strokes are too small for how far from (0, 0) they lie: make them larger, or "
               "move them closer"};
}

/// The strokes that are closed together, in one list for each of the sketch's groups and a last one for those without a
/// group; all in the last one unless the groups become layers.
std::vector<std::vector<int>> strokes_to_close(Sketch const& sketch, Parts parts) {
  std::vector<std::vector<int>> lists(parts == Parts::Groups ? sketch.groups.size() + 1 : 1);
  for (int i = 0; i < std::ssize(sketch.strokes); ++i) {
    int const group = sketch.strokes[i].group;
    bool const is_grouped = parts == Parts::Groups && group >= 0;
    (is_grouped ? lists[group] : lists.back()).push_back(i);
  }
  return lists;
}

/// Strokes that shall become no layer of their own: construction lines, noise, and help lines without the ink that they close.
bool is_left_out(Sketch const& sketch, std::vector<int> const& strokes, Parts parts) {
  if (parts != Parts::Groups || strokes.empty()) return false;
  int const group = sketch.strokes[strokes[0]].group;
  if (group >= 0) return !is_candidate_layer(sketch.groups[group]);
  return std::all_of(strokes.begin(), strokes.end(),
                     [&](int s) { return sketch.strokes[s].kind == StrokeKind::HelpLine; });
}

}  // namespace

std::vector<int> ClosingPlan::without_faint(ClosingGroup const& group) const {
  auto strokes = group.strokes;
  std::erase_if(strokes, [&](int s) { return is_faint[s]; });
  return strokes;
}

Result<ClosingPlan> plan_closing(Sketch const& sketch, SimplifyOptions const& options) {
  if (auto const error = check(options)) return *error;
  if (auto const error = check(sketch)) return *error;
  auto const box = bounds_of(sketch);
  if (auto const error = check(box)) return *error;
  ClosingPlan plan = {WorkSpace::around(box), faint_strokes(sketch), {}};
  for (auto& strokes : strokes_to_close(sketch, options.parts)) {
    bool const is_out = is_left_out(sketch, strokes, options.parts);
    plan.groups.push_back({std::move(strokes), is_out});
  }
  return plan;
}

Error nothing_enclosed() {
  return {ErrorCode::NothingThere,
          "no strokes enclose an area: draw the outline further round, close large openings with "
          "help lines, or allow larger gaps"};
}

}  // namespace inkflate
