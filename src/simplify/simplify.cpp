// SPDX-License-Identifier: Apache-2.0
#include "simplify/simplify.h"

#include <cmath>
#include <numeric>
#include <string>

#include "simplify/close_strokes.h"

namespace inkflate {
namespace {

constexpr double kLargestCoordinate_px = 1e6;

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

Frame frame_of(Sketch const& sketch) {
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  return Frame::around(box);
}

/// The strokes of each group, the ungrouped ones last.
std::vector<std::vector<int>> strokes_by_group(Sketch const& sketch, Parts parts) {
  if (parts != Parts::Groups) {
    std::vector<int> all(sketch.strokes.size());
    std::iota(all.begin(), all.end(), 0);
    return {all};
  }
  std::vector<std::vector<int>> groups(sketch.groups.size() + 1);
  for (int i = 0; i < std::ssize(sketch.strokes); ++i) {
    int const group = sketch.strokes[i].group;
    groups[group < 0 ? sketch.groups.size() : static_cast<std::size_t>(group)].push_back(i);
  }
  return groups;
}

std::string layer_name(Sketch const& sketch, Parts parts, std::size_t group, std::size_t layer) {
  if (parts == Parts::Groups && group < sketch.groups.size()) return sketch.groups[group];
  return "part " + std::to_string(layer + 1);
}

}  // namespace

Result<Drawing> simplify(Sketch const& sketch, SimplifyOptions const& options,
                         Progress const& progress) {
  if (auto const error = check(options)) return *error;
  if (auto const error = check(sketch)) return *error;
  auto const close = options.method == SimplifyMethod::Cut ? close_by_cut : close_by_grid;
  auto const frame = frame_of(sketch);
  Drawing drawing = {sketch, {}, {}};
  auto const groups = strokes_by_group(sketch, options.parts);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    auto closed = close(sketch, groups[group], frame, options, progress);
    if (!closed) return closed.error();
    for (auto& layer : closed->layers) {
      layer.name = layer_name(sketch, options.parts, group, drawing.layers.size());
      drawing.layers.push_back(std::move(layer));
    }
    drawing.stray.insert(drawing.stray.end(), closed->stray.begin(), closed->stray.end());
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
