// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "document/apply.h"
#include "editor/smooth_stroke.h"
#include "editor/tools.h"

namespace inkflate {
namespace {

// Nearer samples are what a resting hand leaves: they tell nothing of the line. About the step of a good tablet.
constexpr double kMergeDistancePx = 0.3;
// Half of the window at the strongest smoothing, px of the screen: a tremble moves a few of them to and fro within 10 to 20.
constexpr double kWidestHalfWindowPx = 16;
// A day: no stroke takes longer, whatever the clock says.
constexpr double kLongestS = 86'400;

double half_window_px(View const& view) {
  double const strength = bounded(view.settings.smoothing, 0, 1);
  return kWidestHalfWindowPx * strength / view.camera.zoom;
}

Step drawing_step(ToolDrawing drawing) {
  Step step;
  step.state = std::move(drawing);
  return step;
}

Step press_brush(StrokeKind kind, ToolPointer const& pointer, View const& view) {
  Stroke stroke;
  stroke.kind = kind;
  stroke.width_px =
      bounded(view.settings.brush_px, ToolSettings::kLeastBrushPx, ToolSettings::kLargestBrushPx);
  stroke.colour = view.settings.ink;
  stroke.depth = pointer.is_secondary ? StrokeDepth::Far : StrokeDepth::Near;
  stroke.samples.push_back({pointer.canvas, pointer.pressure, 0});
  return drawing_step({stroke, stroke, pointer.time_s});
}

/// The pointer as the next sample of a stroke.
Sample next_sample(ToolDrawing const& drawing, ToolPointer const& pointer) {
  double const before = drawing.raw.samples.back().time_s;
  double const now = std::min(pointer.time_s - drawing.start_s, kLongestS);
  return {pointer.canvas, pointer.pressure, std::max(before, now)};
}

void add_sample(std::vector<Sample>& raw, Sample const& next, double zoom) {
  auto& last = raw.back();
  if (distance(last.position, next.position) * zoom < kMergeDistancePx) {
    last.pressure = std::max(last.pressure, next.pressure);
  } else {
    raw.push_back(next);
  }
}

/// The line ends where the pointer was lifted, however near to the last sample; a pen that is lifted presses no more, so that is
/// no pressure of the line.
void add_last_sample(std::vector<Sample>& raw, Sample next, double zoom) {
  auto const& last = raw.back();
  if (last.position == next.position) return;
  bool const is_dot =
      raw.size() == 1 && distance(last.position, next.position) * zoom < kMergeDistancePx;
  if (is_dot) return;
  next.pressure = last.pressure;
  raw.push_back(next);
}

/// With Shift the straight line from the press to the pointer, else the smoothed one.
void update_smooth(ToolDrawing& drawing, Sample const& now, bool is_straight, View const& view) {
  auto const& raw = drawing.raw.samples;
  auto& smooth = drawing.smooth.samples;
  if (is_straight) {
    smooth = {raw.front()};
    if (raw.size() > 1) smooth.push_back(now);
    drawing.is_straight = true;
    return;
  }
  if (drawing.is_straight) smooth.clear();
  drawing.is_straight = false;
  smooth_end(raw, half_window_px(view), smooth);
}

Step finished_stroke(Stroke stroke, ToolContext const& context) {
  Step step = finished();
  step.effect = GestureEffect::Replace;
  step.commands.push_back(
      AddStroke{std::move(stroke), layer_to_draw_on(context.document, context.view)});
  return step;
}

}  // namespace

LayerId layer_to_draw_on(Document const& document, View const& view) {
  LayerId topmost = LayerId::None;
  LayerId selected = LayerId::None;
  int selected_count = 0;
  for (auto const& kept : *document.layers) {
    auto const& layer = kept->layer;
    if (!takes_strokes(layer)) continue;
    topmost = layer.id;
    if (!is_selected(view, layer.id)) continue;
    selected = layer.id;
    ++selected_count;
  }
  return selected_count == 1 ? selected : topmost;
}

Step brush_step(StrokeKind kind, ToolState state, ToolEvent const& event,
                ToolContext const& context) {
  auto const& view = context.view;
  if (std::holds_alternative<ToolHover>(event)) {
    Step step;
    if (view.hover != LayerId::None) step.hover = LayerId::None;
    return step;
  }
  if (auto const* press = std::get_if<ToolPress>(&event)) {
    return press_brush(kind, press->pointer, view);
  }
  auto* drawing = std::get_if<ToolDrawing>(&state);
  if (drawing == nullptr) return {};

  auto& raw = drawing->raw.samples;
  auto const* release = std::get_if<ToolRelease>(&event);
  auto const& pointer = release != nullptr ? release->pointer : std::get<ToolMove>(event).pointer;
  auto const sample = next_sample(*drawing, pointer);
  if (release != nullptr) {
    add_last_sample(raw, sample, view.camera.zoom);
  } else {
    add_sample(raw, sample, view.camera.zoom);
  }
  auto end = sample;
  end.pressure = raw.back().pressure;
  update_smooth(*drawing, end, pointer.modifiers.is_shift, view);
  bool const is_full = std::ssize(raw) >= DocumentLimits::kSamplesOfStroke;
  if (release != nullptr || is_full) return finished_stroke(std::move(drawing->smooth), context);
  return drawing_step(std::move(*drawing));
}

}  // namespace inkflate
