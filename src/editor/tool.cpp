// SPDX-License-Identifier: Apache-2.0
#include "editor/tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "document/apply.h"
#include "editor/pick.h"
#include "editor/tools.h"

namespace inkflate {
namespace {

/// With numbers that a document can hold.
ToolPointer tamed(ToolPointer pointer) {
  double const far = DocumentLimits::kFarthestPx;
  pointer.canvas = {std::clamp(pointer.canvas.x, -far, far),
                    std::clamp(pointer.canvas.y, -far, far)};
  pointer.pressure = pointer.pressure >= 0 ? std::min(pointer.pressure, 1.0) : 0;
  if (!std::isfinite(pointer.time_s)) pointer.time_s = 0;
  return pointer;
}

/// The gesture never was. What it had selected meanwhile is not selected any more where it does not exist any more.
Step cancelled(ToolState const& state) {
  Step step = finished();
  step.effect = GestureEffect::Replace;
  if (auto const* boxing = std::get_if<ToolBoxing>(&state)) step.selection = boxing->before;
  auto const* transforming = std::get_if<ToolTransforming>(&state);
  if (transforming != nullptr && transforming->is_copy) step.selection = transforming->layers;
  return step;
}

Step unchanged(ToolState state) {
  Step step;
  step.state = std::move(state);
  return step;
}

}  // namespace

Step tool_step(Tool tool, ToolState state, ToolEvent const& event, ToolContext const& context) {
  auto tame_event = event;
  ToolPointer* pointer = nullptr;
  if (auto* press = std::get_if<ToolPress>(&tame_event)) pointer = &press->pointer;
  if (auto* move = std::get_if<ToolMove>(&tame_event)) pointer = &move->pointer;
  if (auto* hover = std::get_if<ToolHover>(&tame_event)) pointer = &hover->pointer;
  if (auto* release = std::get_if<ToolRelease>(&tame_event)) pointer = &release->pointer;
  if (pointer == nullptr) return cancelled(state);

  bool const is_idle = std::holds_alternative<ToolIdle>(state);
  bool const wants_idle =
      std::holds_alternative<ToolPress>(event) || std::holds_alternative<ToolHover>(event);
  if (is_idle != wants_idle) return unchanged(std::move(state));
  if (!is_finite(pointer->canvas) || !is_finite(pointer->screen)) {
    bool const is_release = std::holds_alternative<ToolRelease>(event);
    return is_release ? cancelled(state) : unchanged(std::move(state));
  }
  *pointer = tamed(*pointer);
  switch (tool) {
    case Tool::Brush:
      return brush_step(StrokeKind::Ink, std::move(state), tame_event, context);
    case Tool::HelpLine:
      return brush_step(StrokeKind::HelpLine, std::move(state), tame_event, context);
    case Tool::Eraser:
      return eraser_step(state, tame_event, context);
    case Tool::Mark:
      return mark_step(state, tame_event, context);
    case Tool::Deform:
      return deform_step(state, tame_event, context);
    case Tool::Select:
      return select_step(state, tame_event, context);
    case Tool::Hand:
      return hand_step(state, tame_event, context);
  }
  return {};
}

Step hover_step(ToolPointer const& pointer, ToolContext const& context, double reach_px) {
  auto const layer = pick_layer(context.document, pointer.canvas, reach_px, PickDepth::Nearest);
  Step step;
  if (layer != context.view.hover) step.hover = layer;
  return step;
}

}  // namespace inkflate
