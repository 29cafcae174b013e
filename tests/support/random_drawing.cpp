// SPDX-License-Identifier: Apache-2.0
#include "support/random_drawing.h"

#include <array>
#include <cmath>
#include <string>

namespace inkflate::test {
namespace {

Vec2 random_point(Rng& rng) {
  // Whole, short and full-length numbers, also near the limit.
  int const form = rng.below(4);
  Vec2 const point = {rng.uniform(-1000, 2000), rng.uniform(-1000, 2000)};
  if (form == 0) return {std::round(point.x), std::round(point.y)};
  if (form == 1) return point * 500;
  return form == 2 ? point / 1e9 : point;
}

std::string random_name(Rng& rng) {
  char const* const parts[] = {"arm",
                               " ",
                               "<",
                               ">",
                               "&",
                               "\"",
                               "'",
                               "&amp;",
                               "\xc4\x8d",
                               "]]>",
                               "\n",
                               "\t",
                               "\xf0\x9f\x90\x99",
                               "-->"};
  std::string name;
  for (int i = rng.below(6); i > 0; --i) name += parts[rng.below(14)];
  return name;
}

Colour random_colour(Rng& rng) {
  Colour colour;
  for (auto* channel : {&colour.r, &colour.g, &colour.b, &colour.a}) {
    *channel = static_cast<std::uint8_t>(rng.below(256));
  }
  return colour;
}

Stroke random_stroke(Rng& rng, int group_count) {
  Stroke stroke;
  bool const has_pressure = rng.below(2) == 0;
  bool const has_time = rng.below(2) == 0;
  for (int i = rng.below(6); i > 0; --i) {
    stroke.samples.push_back(
        {random_point(rng), has_pressure ? rng.uniform() : 1, has_time ? rng.uniform(0, 60) : 0});
  }
  stroke.kind = rng.below(3) == 0 ? StrokeKind::HelpLine : StrokeKind::Ink;
  stroke.width_px = rng.uniform(0, 9);
  stroke.colour = random_colour(rng);
  stroke.group = rng.below(group_count + 1) - 1;
  if (rng.below(4) == 0) stroke.depth = StrokeDepth::Far;
  return stroke;
}

Outline random_outline(Rng& rng, int stroke_count) {
  Outline outline;
  int const count = 1 + rng.below(6);
  Vec2 const start = random_point(rng);
  Vec2 position = start;
  for (int i = 0; i < count; ++i) {
    Vec2 const end = i + 1 < count ? random_point(rng) : start;
    outline.pieces.push_back({{{position, random_point(rng), random_point(rng), end}},
                              static_cast<RunKind>(rng.below(3))});
    position = end;
  }
  for (int i = rng.below(4); i > 0 && stroke_count > 0; --i) {
    outline.sources.push_back({rng.uniform(0, 3), rng.uniform(3, 6),
                               rng.below(stroke_count + 1) - 1, rng.uniform(0, 99),
                               rng.uniform(0, 99)});
  }
  return outline;
}

std::vector<Vec2> random_points(Rng& rng) {
  std::vector<Vec2> points(static_cast<std::size_t>(rng.below(3)));
  for (auto& point : points) point = random_point(rng);
  return points;
}

CloseChoice random_choice(Rng& rng) {
  if (rng.below(2) == 0) return {};
  return {rng.uniform(0.01, 99), random_points(rng), random_points(rng)};
}

void randomise_state(Rng& rng, Layer& layer) {
  layer.choice = random_choice(rng);
  if (rng.below(2) == 0) layer.id = LayerId{1 + rng.below(99)};
  layer.is_hidden = rng.below(4) == 0;
  layer.is_locked = rng.below(4) == 0;
  layer.is_open = rng.below(4) == 0;
  for (int i = rng.below(3); i > 0; --i) {
    layer.bend_pins.push_back({random_point(rng)});
    if (rng.below(2) == 0) layer.bend_pins.back().turn_rad = rng.uniform(-7, 7);
  }
}

}  // namespace

Drawing random_drawing(Rng& rng) {
  Drawing drawing;
  auto& sketch = drawing.sketch;
  sketch.width_px = rng.uniform(0, 2000);
  sketch.height_px = rng.below(2000);
  for (int i = rng.below(3); i > 0; --i) {
    sketch.groups.push_back({random_name(rng)});
    if (rng.below(2) == 0) sketch.groups.back().fill = random_colour(rng);
    if (rng.below(2) == 0) sketch.groups.back().thickness = rng.uniform(0.1, 32);
  }
  int const stroke_count = rng.below(12);
  int const group_count = static_cast<int>(sketch.groups.size());
  drawing.layers.resize(static_cast<std::size_t>(rng.below(4)));
  for (auto& layer : drawing.layers) {
    layer.name = random_name(rng);
    if (rng.below(2) == 0) layer.fill = random_colour(rng);
    if (rng.below(2) == 0) layer.thickness = rng.uniform(0.1, 32);
    randomise_state(rng, layer);
    for (int i = rng.below(4); i > 0; --i)
      layer.outlines.push_back(random_outline(rng, stroke_count));
  }
  for (int i = 0; i < stroke_count; ++i) {
    sketch.strokes.push_back(random_stroke(rng, group_count));
    int const place = rng.below(1 + 3 * static_cast<int>(drawing.layers.size()));
    if (place == 0) {
      drawing.stray.push_back(i);
    } else {
      auto& layer = drawing.layers[static_cast<std::size_t>((place - 1) / 3)];
      std::array const lists = {&layer.strokes, &layer.details, &layer.noise};
      lists[static_cast<std::size_t>(place % 3)]->push_back(i);
    }
  }
  drawing.choice = random_choice(rng);
  return drawing;
}

}  // namespace inkflate::test
