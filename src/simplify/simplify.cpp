// SPDX-License-Identifier: Apache-2.0
#include "simplify/simplify.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "simplify/close_strokes.h"
#include "simplify/faint_strokes.h"
#include "simplify/sort_strokes.h"

namespace inkflate {
namespace {

constexpr double kLargestCoordinate_px = 1e6;

// Distance of the samples by which strokes are given to layers, work px.
constexpr double kSortSpacing_px = 4;

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
      if (std::abs(p.x) <= kLargestCoordinate_px && std::abs(p.y) <= kLargestCoordinate_px)
        continue;
      return Error{
          ErrorCode::BadInput,
          "stroke " + std::to_string(i) + " has a coordinate that is not a number within 1e6 px",
          i};
    }
  }
  return std::nullopt;
}

WorkSpace space_of(Sketch const& sketch) {
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  return WorkSpace::around(box);
}

/// The working space in which strokes are given to layers. Outlines of whole pixels can be longer than tiny strokes by any factor, so a
/// pixel is at most as long as a stroke may lie from the outline that it draws.
WorkSpace sorting_space(WorkSpace space, SimplifyMethod method) {
  constexpr double kLongestPixel_px = 9;
  if (method == SimplifyMethod::Grid && space.to_work > kLongestPixel_px) {
    space.to_work = kLongestPixel_px;
    space.to_canvas = 1 / kLongestPixel_px;
  }
  return space;
}

/// The strokes that are closed together.
struct Group {
  std::string name;  // empty: of strokes without a group
  std::vector<int> strokes;
};

std::vector<Group> groups_of(Sketch const& sketch, Parts parts) {
  std::vector<Group> groups(parts == Parts::Groups ? sketch.groups.size() + 1 : 1);
  for (std::size_t g = 0; g + 1 < groups.size(); ++g) groups[g].name = sketch.groups[g];
  for (int i = 0; i < std::ssize(sketch.strokes); ++i) {
    int const group = sketch.strokes[i].group;
    bool const is_grouped = parts == Parts::Groups && group >= 0;
    (is_grouped ? groups[group] : groups.back()).strokes.push_back(i);
  }
  return groups;
}

Result<std::vector<Layer>> close(Sketch const& sketch, std::span<int const> chosen,
                                 WorkSpace const& space, SimplifyOptions const& options,
                                 Progress const& progress) {
  if (options.method == SimplifyMethod::Grid)
    return close_by_grid(sketch, chosen, options, progress);
  auto const is_faint = faint_strokes(sketch);
  std::vector<int> strong;
  std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(strong),
               [&](int s) { return !is_faint[s]; });
  return close_by_cut(sketch, strong, space, options, progress);
}

}  // namespace

Result<Drawing> simplify(Sketch const& sketch, SimplifyOptions const& options,
                         Progress const& progress) {
  if (auto const error = check(options)) return *error;
  if (auto const error = check(sketch)) return *error;
  auto const space = space_of(sketch);
  auto const sorting = sorting_space(space, options.method);
  Drawing drawing = {sketch, {}, {}};
  for (auto const& group : groups_of(sketch, options.parts)) {
    auto layers = close(sketch, group.strokes, space, options, progress);
    if (!layers) return layers.error();
    if (!progress.enter("sort")) return Error{ErrorCode::Cancelled, "stopped on request"};
    auto const samples = sample_strokes(sketch, group.strokes, sorting, kSortSpacing_px);
    auto const stray = sort_strokes(samples, sorting, *layers);
    drawing.stray.insert(drawing.stray.end(), stray.begin(), stray.end());
    for (auto& layer : *layers) {
      layer.name =
          group.name.empty() ? "part " + std::to_string(drawing.layers.size() + 1) : group.name;
      drawing.layers.push_back(std::move(layer));
    }
  }
  if (drawing.layers.empty()) {
    return Error{ErrorCode::NothingThere,
                 "no strokes enclose an area: draw the outline further round, close large openings "
                 "with help lines, or "
                 "allow larger gaps"};
  }
  return drawing;
}

}  // namespace inkflate
