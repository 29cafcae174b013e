// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_guides.h"

#include <utility>

#include "editor/scene_strokes.h"
#include "editor/screen_shapes.h"
#include "render/lay_picture.h"
#include "render/line_pattern.h"
#include "render/palette.h"

namespace inkflate {
namespace {

constexpr double kTemplateOpacity = 0.4;

/// Bridges over gaps: as wide as a usual pen, but always to be seen and never a blot.
constexpr double kBridgePx = 3;
constexpr WidthLimits kBridgeLimits = {2.5, 5};

constexpr double kBoxShare = 0.1;  // how opaque a box around layers is

constexpr double kMarkRadiusPx = 8;
constexpr double kSignPx = 3.5;  // from a mark's middle to the ends of its sign

class MarkPainter {
 public:
  explicit MarkPainter(View const& view)
      : size_(view.size), map_(canvas_to_screen(view.camera, view.size)) {}

  void add(CloseChoice const& choice) {
    for (auto const place : choice.outside) add(place, palette::kClosing, false);
    for (auto const place : choice.inside) add(place, palette::kHelpLine, true);
  }

  DrawList list;

 private:
  void add(Vec2 canvas, Colour colour, bool is_plus) {
    Vec2 const p = map_(canvas);
    double const reach = 2 * kMarkRadiusPx;
    if (!(p.x > -reach && p.y > -reach && p.x < size_.width_px + reach &&
          p.y < size_.height_px + reach)) {
      return;
    }
    add_ring(list, p, kMarkRadiusPx, colour);
    Vec2 const across = {kSignPx, 0};
    list.push_back(screen_line({p - across, p + across}, 2, colour));
    if (is_plus) {
      list.push_back(
          screen_line({p - perpendicular(across), p + perpendicular(across)}, 2, colour));
    }
  }

  ViewSize size_;
  Affine map_;
};

struct ToolPainter {
  DrawList operator()(ToolDrawing const& drawing) const {
    if (drawing.smooth.samples.empty()) return {};
    return {rough_line(drawing.smooth)};
  }
  DrawList operator()(ToolBoxing const& boxing) const {
    Rect box;
    box.include(boxing.from);
    box.include(boxing.to);
    auto const corners = rim(box);
    return {FilledPath{{corners}, faded(palette::kSelection, kBoxShare)},
            screen_line(corners, 3, palette::kHalo),
            screen_line(corners, 1.25, palette::kSelection)};
  }
  template <typename Other>
  DrawList operator()(Other const&) const {
    return {};
  }
};

}  // namespace

DrawList draw_template(Document const& document) {
  auto const& picture = document.template_picture;
  if (!picture || picture->values.empty()) return {};
  return {DrawnPicture{picture, lay_picture(*picture, document.width_px, document.height_px),
                       kTemplateOpacity}};
}

DrawList draw_preview_area(ShapePreview const& preview) {
  DrawList list;
  for (std::size_t i = 0; i < preview.contours.size(); ++i) {
    bool const is_new = i == 0 || preview.areas[i] != preview.areas[i - 1];
    if (is_new) list.push_back(FilledPath{{}, palette::kShape});
    std::get<FilledPath>(list.back()).contours.push_back(preview.contours[i]);
  }
  return list;
}

DrawList draw_preview_closings(ShapePreview const& preview) {
  DrawList list;
  for (auto const& closing : preview.closings) {
    if (closing.empty()) continue;
    list.push_back(
        StrokedPolyline{closing, {kBridgePx}, dotted(kBridgePx), palette::kClosing, kBridgeLimits});
  }
  return list;
}

DrawList draw_tool(ToolState const& tool) { return std::visit(ToolPainter{}, tool); }

DrawList draw_marks(Document const& document, View const& view) {
  MarkPainter painter(view);
  if (!document.loose.is_empty()) painter.add(*document.choice);
  for (auto const& layer : *document.layers) {
    if (layer->layer.is_hidden) continue;
    if (layer->layer.is_open || view.tool == Tool::Mark) painter.add(layer->layer.choice);
  }
  return std::move(painter.list);
}

}  // namespace inkflate
