// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_frame.h"

#include <memory>

#include "editor/screen_shapes.h"
#include "render/palette.h"

namespace inkflate {
namespace {

constexpr double kHandlePx = 4.5;  // half a square's side
constexpr double kKnobPx = 5.5;    // radius
constexpr double kHaloPx = 2.75;   // width of what lies under the lines

void add_line(DrawList& list, Polyline const& points) {
  list.push_back(screen_line(points, kHaloPx, palette::kHalo));
  list.push_back(screen_line(points, 1, palette::kSelection));
}

void add_square(DrawList& list, Vec2 centre) {
  Vec2 const reach = {kHandlePx, kHandlePx};
  auto const square = rim({centre - reach, centre + reach});
  list.push_back(screen_line(square, kHaloPx + 0.5, palette::kHalo));
  list.push_back(FilledPath{{square}, palette::kHalo});
  list.push_back(screen_line(square, 1.5, palette::kSelection));
}

}  // namespace

DrawList draw_frame(Frame const& frame, Affine const& to_screen) {
  auto corners = rim(frame.box);
  for (auto& corner : corners) corner = to_screen(corner);
  DrawList list;
  add_line(list, corners);
  for (auto const& [handle, place] : frame.handles) {
    if (handle == FrameHandle::Turn) {
      add_line(list, {lerp(corners[0], corners[1], 0.5), place});
      add_ring(list, place, kKnobPx, palette::kSelection);
    } else if (handle != FrameHandle::Inside) {
      add_square(list, place);
    }
  }
  return list;
}

void FrameChunk::add(Document const& document, View const& view, std::uint64_t& next_id,
                     std::vector<SceneChunk>& chunks) {
  bool const is_same = document.layers == layers_ && view.selection == selection_ &&
                       view.camera == camera_ && view.size == size_;
  if (!is_same) {
    auto const frame = selection_frame(document, view);
    chunk_ = {};
    if (frame) {
      auto list = draw_frame(*frame, canvas_to_screen(view.camera, view.size));
      chunk_ = {next_id++, SceneSpace::Screen, std::make_shared<DrawList const>(std::move(list))};
    }
    layers_ = document.layers;
    selection_ = view.selection;
    camera_ = view.camera;
    size_ = view.size;
  }
  if (chunk_.list) chunks.push_back(chunk_);
}

}  // namespace inkflate
