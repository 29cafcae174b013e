// SPDX-License-Identifier: Apache-2.0
#include "editor/pick_bend.h"

#include <limits>

#include "editor/layer_shape.h"
#include "editor/pins.h"
#include "geometry/segment.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

/// The nearest place of lines so far.
class NearestPlace {
 public:
  explicit NearestPlace(Vec2 from) : from_(from) {}

  void add_segment(Vec2 a, Vec2 b) {
    auto const p = nearest_on_segment(from_, a, b);
    double const size = squared_norm(p - from_);
    if (size >= squared_px) return;
    squared_px = size;
    place = p;
  }

  Vec2 place;
  double squared_px = std::numeric_limits<double>::infinity();

 private:
  Vec2 from_;
};

NearestPlace nearest_on(LayerShape const& shape, Vec2 from) {
  NearestPlace nearest(from);
  for (auto const& contour : shape.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      nearest.add_segment(contour[i], contour[(i + 1) % contour.size()]);
    }
  }
  return nearest;
}

NearestPlace nearest_on(Stroke const& stroke, Vec2 from) {
  NearestPlace nearest(from);
  auto const& samples = stroke.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    nearest.add_segment(samples[i == 0 ? 0 : i - 1].position, samples[i].position);
  }
  return nearest;
}

std::optional<BendHit> pick_rough(Document const& document, Vec2 canvas, double reach_px) {
  std::optional<BendHit> hit;
  double least = std::numeric_limits<double>::infinity();
  for (auto const& ref : strokes_near(document, canvas, canvas, reach_px)) {
    auto const* const layer = find_layer(document, ref.layer);
    auto const& strokes = layer == nullptr ? document.loose : layer->strokes;
    auto const nearest = nearest_on(strokes[ref.index]->stroke, canvas);
    if (nearest.squared_px >= least) continue;
    least = nearest.squared_px;
    hit = BendHit{{LayerId::None, ref, {}, nearest.place}, true};
  }
  return hit;
}

std::optional<BendHit> pick_part(Document const& document, Vec2 canvas, double reach_px,
                                 PickDepth depth) {
  std::optional<BendHit> hit;
  double least = reach_px * reach_px;
  auto const& layers = *document.layers;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    auto const& layer = *layers[depth == PickDepth::Farthest ? i : layers.size() - 1 - i];
    // The outlines of an open one are those of before.
    if (!is_pickable(layer) || layer.layer.is_open) continue;
    if (!contains(loose_box(layer.layer).grown(reach_px), canvas)) continue;
    auto const shape = layer_shape(layer.layer);
    auto const nearest = nearest_on(shape, canvas);
    auto const id = layer.layer.id;
    if (nearest.squared_px <= least) {
      least = nearest.squared_px;
      hit = BendHit{{id, {}, {}, nearest.place}, true};
    }
    if (!contains(shape, canvas)) continue;
    return hit ? hit : BendHit{{id, {}, {}, canvas, true}, false};
  }
  return hit;
}

}  // namespace

std::optional<BendPinRef> pick_pin(Document const& document, View const& view, Vec2 screen,
                                   double reach_px) {
  auto const to_screen = canvas_to_screen(view.camera, view.size);
  std::optional<BendPinRef> nearest;
  double least = reach_px * reach_px;
  for (auto const& pin : pins_of(document)) {
    double const size = squared_norm(to_screen(find_pin(document, pin)->position) - screen);
    // Of two at one place the one in front.
    if (nearest ? size >= least : size > least) continue;
    least = size;
    nearest = pin;
  }
  return nearest;
}

Vec2 pin_knob(BendPin const& pin, View const& view) {
  auto const turn = sin_cos(pin.turn_rad.value_or(0));
  auto const to_screen = canvas_to_screen(view.camera, view.size);
  auto const centre = to_screen(pin.position);
  double const side = view.camera.is_mirrored ? -1 : 1;
  return centre + Vec2{side * turn.sin, -turn.cos} * kPinRingPx;
}

std::optional<BendHit> pick_to_bend(Document const& document, Vec2 canvas, double reach_px,
                                    PickDepth depth) {
  if (auto hit = pick_rough(document, canvas, reach_px)) return hit;
  return pick_part(document, canvas, reach_px, depth);
}

}  // namespace inkflate
