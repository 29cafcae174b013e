// SPDX-License-Identifier: Apache-2.0
#include "simplify/simplify.h"

#include <algorithm>
#include <string>

#include "simplify/close_strokes.h"
#include "simplify/closing_plan.h"
#include "simplify/limb_mouths.h"
#include "simplify/sort_strokes.h"

namespace inkflate {
namespace {

// Distance of the samples by which strokes are given to layers, work px.
constexpr double kSortSpacingPx = 4;

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

/// Gives the strokes of a group to its layers.
void sort_group(Sketch const& sketch, WorkSpace const& space, GroupShapes& group) {
  auto const samples = sample_strokes(sketch, group.strokes, space, kSortSpacingPx);
  group.stray = sort_strokes(samples, space, group.layers);
}

}  // namespace

Result<Drawing> simplify(Sketch const& sketch, SimplifyOptions const& options,
                         Progress const& progress) {
  auto const plan = plan_closing(sketch, options);
  if (!plan) return plan.error();
  auto const sorting = sorting_space(plan->space, options.method);
  Drawing drawing = {sketch, {}, {}};
  std::vector<GroupShapes> groups;
  for (auto const& group : plan->groups) {
    if (group.is_left_out) {
      groups.push_back({{}, {}, group.strokes});
      continue;
    }
    auto layers =
        options.method == SimplifyMethod::Grid
            ? close_by_grid(sketch, group.strokes, options, progress)
            : close_by_cut(sketch, plan->without_faint(group), plan->space, options, progress);
    if (!layers) return layers.error();
    if (!progress.enter("sort")) return Error{ErrorCode::Cancelled, "stopped on request"};
    groups.push_back({group.strokes, *std::move(layers), {}});
    sort_group(sketch, sorting, groups.back());
  }
  if (options.method == SimplifyMethod::Cut) {
    // Hosts are groups that take no part themselves.
    auto const own_count = groups.size();
    for (auto const& host : options.hosts) groups.push_back({{}, {Layer{"", {host}, {}, {}}}, {}});
    auto const changed =
        close_limb_mouths(sketch, plan->is_faint, plan->space, options, progress, groups);
    if (!changed) return changed.error();
    groups.resize(own_count);
    for (int const g : *changed) sort_group(sketch, sorting, groups[g]);
  }
  for (auto& group : groups) {
    drawing.stray.insert(drawing.stray.end(), group.stray.begin(), group.stray.end());
    name_layers(sketch, group.strokes, group.layers);
    for (auto& layer : group.layers) drawing.layers.push_back(std::move(layer));
  }
  if (drawing.layers.empty()) return nothing_enclosed();
  return drawing;
}

}  // namespace inkflate
