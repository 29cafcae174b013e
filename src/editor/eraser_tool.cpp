// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
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
DocumentLayer const* layer_at(Document const& document, Vec2 place, double radius) {
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

/// The first such layer that the eraser meets on a stretch.
DocumentLayer const* layer_on_way(Document const& document, Vec2 from, Vec2 to, double radius) {
  // Looks from afar need not be closer than this: a gesture that fast leaves nothing to aim at.
  constexpr int most_looks = 64;
  int const looks = static_cast<int>(
      std::clamp(std::ceil(distance(from, to) / radius), 1.0, static_cast<double>(most_looks)));
  for (int i = from == to ? looks : 0; i <= looks; ++i) {
    auto const* const layer =
        layer_at(document, lerp(from, to, static_cast<double>(i) / looks), radius);
    if (layer != nullptr) return layer;
  }
  return nullptr;
}

struct Erasing {
  Vec2 last;
  bool is_lines = false;
  bool has_met = false;  // something to erase
};

ToolState state_of(Erasing const& erasing) {
  if (erasing.is_lines) return ToolErasingLines{erasing.last, erasing.has_met};
  return ToolErasing{erasing.last, erasing.has_met};
}

std::optional<Erasing> erasing_of(ToolState const& state) {
  if (auto const* const area = std::get_if<ToolErasing>(&state)) {
    return Erasing{area->last, false, area->has_met};
  }
  if (auto const* const lines = std::get_if<ToolErasingLines>(&state)) {
    return Erasing{lines->last, true, lines->has_met};
  }
  return std::nullopt;
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

/// Erases along a stretch. A gesture works on what it meets first: rough strokes, or a closed layer, which it opens.
Step erase(Erasing erasing, Vec2 to, ToolContext const& context) {
  double const radius = radius_px(context.view);
  auto const from = std::exchange(erasing.last, to);
  Step step;
  auto strokes = strokes_near(context.document, from, to, radius);
  if (strokes.empty() && !erasing.has_met) {
    if (auto const* const layer = layer_on_way(context.document, from, to, radius)) {
      erasing.has_met = true;
      step.effect = GestureEffect::Append;
      step.commands.push_back(OpenLayer{layer->layer.id});
      for (int const index : strokes_near(layer->strokes, from, to, radius)) {
        strokes.push_back({layer->layer.id, index});
      }
    }
  }
  erasing.has_met = erasing.has_met || !strokes.empty();
  add_erasing(std::move(strokes), from, to, erasing.is_lines, radius, step);
  step.state = state_of(erasing);
  return step;
}

}  // namespace

Step eraser_step(ToolState const& state, ToolEvent const& event, ToolContext const& context) {
  if (auto const* const hover = std::get_if<ToolHover>(&event)) {
    return hover_step(hover->pointer, context, radius_px(context.view));
  }
  if (auto const* const press = std::get_if<ToolPress>(&event)) {
    auto const place = press->pointer.canvas;
    return erase({place, press->pointer.modifiers.is_alt, false}, place, context);
  }
  auto const erasing = erasing_of(state);
  if (!erasing) return {};
  if (auto const* const move = std::get_if<ToolMove>(&event)) {
    return erase(*erasing, move->pointer.canvas, context);
  }
  auto const* const release = std::get_if<ToolRelease>(&event);
  if (release == nullptr || release->pointer.canvas == erasing->last) return finished();
  auto step = erase(*erasing, release->pointer.canvas, context);
  step.state = ToolIdle{};
  step.is_end = true;
  return step;
}

}  // namespace inkflate
