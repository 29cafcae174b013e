// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "editor/layer_shape.h"
#include "editor/pick.h"
#include "editor/tools.h"

namespace inkflate {
namespace {

double radius_px(View const& view) {
  double const on_screen = bounded(view.settings.eraser_px, ToolSettings::kLeastEraserPx,
                                   ToolSettings::kLargestEraserPx);
  return on_screen / view.camera.zoom;
}

/// The nearest closed layer whose rim or strokes lie under the eraser: the one that a person wants to repair there. One without
/// strokes has nothing to be erased.
DocumentLayer const* layer_to_open(Document const& document, Vec2 place, double radius) {
  auto const& layers = *document.layers;
  for (auto each = layers.rbegin(); each != layers.rend(); ++each) {
    auto const& kept = **each;
    if (!is_pickable(kept) || kept.layer.is_open || kept.strokes.is_empty()) continue;
    if (contains(loose_box(kept.layer).grown(radius), place) &&
        is_rim_near(layer_shape(kept.layer), place, radius)) {
      return &kept;
    }
    if (!strokes_near(kept.strokes, place, place, radius).empty()) return &kept;
  }
  return nullptr;
}

ToolState erasing_at(Vec2 place, bool is_lines) {
  if (is_lines) return ToolErasingLines{place};
  return ToolErasing{place};
}

/// What erases these strokes, or what of them lies under the stretch; nothing where there are none.
void add_erasing(std::vector<StrokeRef> strokes, Vec2 from, Vec2 to, bool is_lines, double radius,
                 Step& step) {
  if (strokes.empty()) return;
  step.effect = GestureEffect::Append;
  if (is_lines) {
    step.commands.push_back(EraseStrokes{std::move(strokes)});
  } else {
    step.commands.push_back(EraseArea{from == to ? Polyline{from} : Polyline{from, to}, radius});
  }
}

Step press_eraser(ToolPointer const& pointer, ToolContext const& context) {
  auto const place = pointer.canvas;
  bool const is_lines = pointer.modifiers.is_alt;
  double const radius = radius_px(context.view);
  Step step;
  step.state = erasing_at(place, is_lines);
  auto strokes = strokes_near(context.document, place, place, radius);
  if (strokes.empty()) {
    auto const* layer = layer_to_open(context.document, place, radius);
    if (layer == nullptr) return step;
    step.effect = GestureEffect::Append;
    step.commands.push_back(OpenLayer{layer->layer.id});
    for (int const index : strokes_near(layer->strokes, place, place, radius)) {
      strokes.push_back({layer->layer.id, index});
    }
  }
  add_erasing(std::move(strokes), place, place, is_lines, radius, step);
  return step;
}

}  // namespace

Step eraser_step(ToolState const& state, ToolEvent const& event, ToolContext const& context) {
  double const radius = radius_px(context.view);
  if (auto const* hover = std::get_if<ToolHover>(&event)) {
    return hover_step(hover->pointer, context, radius);
  }
  if (auto const* press = std::get_if<ToolPress>(&event)) {
    return press_eraser(press->pointer, context);
  }
  auto const* area = std::get_if<ToolErasing>(&state);
  auto const* lines = std::get_if<ToolErasingLines>(&state);
  if (area == nullptr && lines == nullptr) return {};
  bool const is_lines = lines != nullptr;
  auto const last = is_lines ? lines->last : area->last;

  auto const* release = std::get_if<ToolRelease>(&event);
  auto const place =
      release != nullptr ? release->pointer.canvas : std::get<ToolMove>(event).pointer.canvas;
  Step step;
  if (release != nullptr) {
    step = finished();
  } else {
    step.state = erasing_at(place, is_lines);
  }
  // Without a stretch everything near is gone already.
  if (place == last) return step;
  add_erasing(strokes_near(context.document, last, place, radius), last, place, is_lines, radius,
              step);
  return step;
}

}  // namespace inkflate
