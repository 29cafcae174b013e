// SPDX-License-Identifier: Apache-2.0
#include "document/give_room.h"

#include <cmath>
#include <utility>

#include "document/transform.h"
#include "geometry/affine.h"
#include "geometry/rect.h"

namespace inkflate {
namespace {

// Between the outermost line and the border of a canvas that grows.
constexpr double kMarginPx = 16;

Rect box_of(Drawing const& drawing) {
  Rect box;
  for (auto const& stroke : drawing.sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  for (auto const& layer : drawing.layers) {
    for (auto const& outline : layer.outlines) {
      for (auto const& piece : outline.pieces) {
        for (auto const point : piece.curve.control) box.include(point);
      }
    }
  }
  return box;
}

// Whole pixels, so that what was sharp stays so.
double new_start(double least) { return least < 0 ? std::floor(least - kMarginPx) : 0; }
double new_end(double most, double end) { return most > end ? std::ceil(most + kMarginPx) : end; }

void move(Project& project, Vec2 way) {
  auto const map = Affine::translation(way);
  auto& drawing = project.drawing;
  for (auto& stroke : drawing.sketch.strokes) stroke = transformed(std::move(stroke), map);
  for (auto& layer : drawing.layers) layer = transformed(std::move(layer), map);
  drawing.choice = transformed(std::move(drawing.choice), map);
  for (auto& pin : project.pins) {
    pin.rest = pin.rest + way;
    pin.position = pin.position + way;
  }
  for (auto& track : project.clip.tracks) {
    for (auto& key : track.keys) key.position = key.position + way;
  }
}

}  // namespace

Project give_room(Project project) {
  auto& sketch = project.drawing.sketch;
  auto const box = box_of(project.drawing);
  bool const fits =
      box.is_empty() || (box.min.x >= 0 && box.min.y >= 0 && box.max.x <= sketch.width_px &&
                         box.max.y <= sketch.height_px);
  if (fits || project.template_picture) return project;
  Vec2 const corner = {new_start(box.min.x), new_start(box.min.y)};
  Vec2 const far = {new_end(box.max.x, sketch.width_px), new_end(box.max.y, sketch.height_px)};
  sketch.width_px = far.x - corner.x;
  sketch.height_px = far.y - corner.y;
  move(project, Vec2{} - corner);
  return project;
}

}  // namespace inkflate
