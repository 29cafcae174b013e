// SPDX-License-Identifier: Apache-2.0
#include "simplify/simplify.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "simplify/close_strokes.h"
#include "simplify/faint_strokes.h"
#include "simplify/limb_mouths.h"
#include "simplify/sort_strokes.h"

namespace inkflate {
namespace {

constexpr double kLargestCoordinatePx = 1e6;

// The longer side of the strokes is at least this share of their coordinates. Rounding to doubles is then 2e-5 work px and less, far
// below what keeps outlines from crossing.
constexpr double kLeastSize = 1e-8;

// Distance of the samples by which strokes are given to layers, work px.
constexpr double kSortSpacingPx = 4;

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

/// The space in which strokes are given to layers. Outlines of whole pixels can be longer than tiny strokes by any factor, so a
/// pixel is at most as long as a stroke may lie from the outline that it draws.
WorkSpace sorting_space(WorkSpace space, SimplifyMethod method) {
  constexpr double longest_pixel_px = 9;
  if (method == SimplifyMethod::Grid && space.to_work > longest_pixel_px) {
    space.to_work = longest_pixel_px;
    space.to_canvas = 1 / longest_pixel_px;
  }
  return space;
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

/// The group that all of these strokes are in; -1: none.
int common_group(Sketch const& sketch, std::vector<int> const& strokes) {
  if (strokes.empty()) return -1;
  int const group = sketch.strokes[strokes[0]].group;
  bool const is_common = std::all_of(strokes.begin(), strokes.end(),
                                     [&](int s) { return sketch.strokes[s].group == group; });
  return is_common ? group : -1;
}

/// Layers, made of these strokes, take over name, colour and thickness of their group. Pieces of one group are told apart by numbers; those of
/// no group are only numbers.
void name_layers(Sketch const& sketch, std::vector<int> const& strokes,
                 std::vector<Layer>& layers) {
  std::vector<int> pieces(sketch.groups.size(), 0);
  for (int part = 1; auto& layer : layers) {
    int const group = common_group(sketch, layer.strokes.empty() ? strokes : layer.strokes);
    layer.name = "part " + std::to_string(part++);
    if (group < 0) continue;
    auto const& [name, fill, thickness] = sketch.groups[group];
    int const piece = ++pieces[group];
    if (!name.empty()) layer.name = piece == 1 ? name : name + " " + std::to_string(piece);
    layer.fill = fill;
    layer.thickness = thickness;
  }
}

/// The strokes of a group that are no construction lines.
std::vector<int> without(std::vector<bool> const& is_faint, std::vector<int> strokes) {
  std::erase_if(strokes, [&](int s) { return is_faint[s]; });
  return strokes;
}

/// Gives the strokes of a group to its layers.
void sort_group(Sketch const& sketch, WorkSpace const& space, GroupShapes& group) {
  auto const samples = sample_strokes(sketch, group.strokes, space, kSortSpacingPx);
  group.stray = sort_strokes(samples, space, group.layers);
}

}  // namespace

Result<Drawing> simplify(Sketch const& sketch, SimplifyOptions const& options,
                         Progress const& progress) {
  if (auto const error = check(options)) return *error;
  if (auto const error = check(sketch)) return *error;
  auto const box = bounds_of(sketch);
  if (auto const error = check(box)) return *error;
  auto const space = WorkSpace::around(box);
  auto const sorting = sorting_space(space, options.method);
  auto const is_faint = faint_strokes(sketch);
  Drawing drawing = {sketch, {}, {}};
  std::vector<GroupShapes> groups;
  for (auto& strokes : strokes_to_close(sketch, options.parts)) {
    if (is_left_out(sketch, strokes, options.parts)) {
      groups.push_back({{}, {}, std::move(strokes)});
      continue;
    }
    auto layers = options.method == SimplifyMethod::Grid
                      ? close_by_grid(sketch, strokes, options, progress)
                      : close_by_cut(sketch, without(is_faint, strokes), space, options, progress);
    if (!layers) return layers.error();
    if (!progress.enter("sort")) return Error{ErrorCode::Cancelled, "stopped on request"};
    groups.push_back({std::move(strokes), *std::move(layers), {}});
    sort_group(sketch, sorting, groups.back());
  }
  if (options.method == SimplifyMethod::Cut) {
    auto const changed = close_limb_mouths(sketch, is_faint, space, options, progress, groups);
    if (!changed) return changed.error();
    for (int const g : *changed) sort_group(sketch, sorting, groups[g]);
  }
  for (auto& group : groups) {
    drawing.stray.insert(drawing.stray.end(), group.stray.begin(), group.stray.end());
    name_layers(sketch, group.strokes, group.layers);
    for (auto& layer : group.layers) drawing.layers.push_back(std::move(layer));
  }
  if (drawing.layers.empty()) {
    return Error{
        ErrorCode::NothingThere,
        "no strokes enclose an area: draw the outline further round, close large openings with "
        "help lines, or allow larger gaps"};
  }
  return drawing;
}

}  // namespace inkflate
