// SPDX-License-Identifier: Apache-2.0
#include "document/transform.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace inkflate {
namespace {

void turn_around(Outline& outline) {
  std::reverse(outline.pieces.begin(), outline.pieces.end());
  for (auto& piece : outline.pieces) {
    std::reverse(piece.curve.control.begin(), piece.curve.control.end());
  }
  auto const count = static_cast<double>(std::ssize(outline.pieces));
  std::reverse(outline.sources.begin(), outline.sources.end());
  for (auto& source : outline.sources) {
    double const from = source.from;
    source.from = count - source.to;
    source.to = count - from;
    std::swap(source.sample_from, source.sample_to);
  }
}

}  // namespace

Stroke transformed(Stroke stroke, Affine const& map) {
  for (auto& sample : stroke.samples) sample.position = map(sample.position);
  stroke.width_px *= map.mean_scale();
  return stroke;
}

StrokeList transformed(StrokeList const& strokes, Affine const& map) {
  std::vector<Shared<KeptStroke>> moved;
  moved.reserve(static_cast<std::size_t>(strokes.size()));
  strokes.for_each(
      [&](auto const& kept) { moved.push_back(keep(transformed(kept->stroke, map))); });
  return StrokeList::of(moved);
}

CloseChoice transformed(CloseChoice choice, Affine const& map) {
  for (auto* marks : {&choice.outside, &choice.inside}) {
    for (auto& mark : *marks) mark = map(mark);
  }
  if (choice.gap_px) *choice.gap_px *= map.mean_scale();
  return choice;
}

Outline transformed(Outline outline, Affine const& map) {
  for (auto& piece : outline.pieces) {
    for (auto& point : piece.curve.control) point = map(point);
  }
  if (map.determinant() < 0) turn_around(outline);
  return outline;
}

Layer transformed(Layer layer, Affine const& map) {
  for (auto& outline : layer.outlines) outline = transformed(std::move(outline), map);
  layer.choice = transformed(std::move(layer.choice), map);
  for (auto& pin : layer.bend_pins) {
    pin.position = map(pin.position);
    if (pin.turn_rad && map.determinant() < 0) pin.turn_rad = -*pin.turn_rad;
  }
  return layer;
}

}  // namespace inkflate
