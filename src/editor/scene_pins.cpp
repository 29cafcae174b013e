// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_pins.h"

#include <utility>

#include "editor/pick_bend.h"
#include "editor/screen_shapes.h"
#include "geometry/trig.h"
#include "render/line_pattern.h"
#include "render/palette.h"

namespace inkflate {
namespace {

// Screen px.
constexpr double kPinPx = 5;          // radius
constexpr double kSelectedPinPx = 7;  // radius
constexpr double kKnobPx = 5.5;       // radius
constexpr double kHandPx = 6;         // radius
constexpr double kHaloPx = 1.5;       // around dots
constexpr double kTickPx = 12;        // from a pin to where it points
constexpr double kLinePx = 1.5;
constexpr double kRingPx = 1.25;

/// The chords of the largest ring on a screen stay within half a px of it.
constexpr int kRingPoints = 96;

Polyline circle(Vec2 centre, double radius) {
  Polyline points;
  for (int i = 0; i <= kRingPoints; ++i) {
    auto const turn = sin_cos(2 * kPi * i / kRingPoints);
    points.push_back(centre + Vec2{turn.cos, turn.sin} * radius);
  }
  return points;
}

void add_dot(DrawList& list, Vec2 centre, double radius) {
  list.push_back(Dots{{centre}, 2 * (radius + kHaloPx), palette::kHalo});
  list.push_back(Dots{{centre}, 2 * radius, palette::kSelection});
}

void add_line(DrawList& list, Polyline const& points, double width_px) {
  list.push_back(screen_line(points, width_px + 2 * kHaloPx, palette::kHalo));
  list.push_back(screen_line(points, width_px, palette::kSelection));
}

class PinPainter {
 public:
  explicit PinPainter(View const& view)
      : view_(view), map_(canvas_to_screen(view.camera, view.size)) {}

  void add(BendPin const& pin, bool is_locked) {
    auto const place = map_(pin.position);
    if (!is_in_view(place, kTickPx)) return;
    if (pin.turn_rad) {
      auto const knob = pin_knob(pin, view_);
      add_line(list, {place, place + (knob - place) * (kTickPx / kPinRingPx)}, kLinePx);
    }
    if (is_locked) {
      add_ring(list, place, kPinPx, palette::kSelection);
    } else {
      add_dot(list, place, kPinPx);
    }
  }

  void add_selected(BendPin const& pin) {
    auto const place = map_(pin.position);
    if (!is_in_view(place, 2 * kPinRingPx)) return;
    auto const knob = pin_knob(pin, view_);
    add_line(list, circle(place, kPinRingPx), kRingPx);
    if (pin.turn_rad) {
      add_line(list, {place, knob}, kLinePx);
      add_dot(list, knob, kKnobPx);
    } else {
      add_ring(list, knob, kKnobPx, palette::kSelection);
    }
    add_dot(list, place, kSelectedPinPx);
  }

  void add_hand(ToolBending const& bend) {
    auto const place = map_(bend.target);
    if (bend.ring_px) {
      auto ring = screen_line(circle(place, *bend.ring_px * view_.camera.zoom), kLinePx,
                              palette::kSelection);
      ring.dashes_px = dashed(kLinePx);
      list.push_back(std::move(ring));
    }
    if (!bend.what.pin) add_ring(list, place, kHandPx, palette::kSelection);
  }

  DrawList list;

 private:
  bool is_in_view(Vec2 p, double reach) const {
    return p.x > -reach && p.y > -reach && p.x < view_.size.width_px + reach &&
           p.y < view_.size.height_px + reach;
  }

  View const& view_;
  Affine map_;
};

}  // namespace

DrawList draw_pins(Document const& document, View const& view, ToolState const& tool) {
  if (view.tool != Tool::Deform) return {};
  PinPainter painter(view);
  BendPin const* selected = nullptr;
  for (auto const& layer : *document.layers) {
    auto const& data = layer->layer;
    if (data.is_hidden) continue;
    for (int i = 0; i < std::ssize(data.bend_pins); ++i) {
      auto const& pin = data.bend_pins[static_cast<std::size_t>(i)];
      if (view.pin == BendPinRef{data.id, i}) {
        selected = &pin;
      } else {
        painter.add(pin, data.is_locked);
      }
    }
  }
  if (selected != nullptr) painter.add_selected(*selected);
  if (auto const* const bend = std::get_if<ToolBending>(&tool)) painter.add_hand(*bend);
  return std::move(painter.list);
}

}  // namespace inkflate
