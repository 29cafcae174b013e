// SPDX-License-Identifier: Apache-2.0
#include "model/drawing.h"

#include <iterator>
#include <map>
#include <utility>

namespace inkflate {

Contour flatten(Outline const& outline, double tolerance_px) {
  Contour contour;
  for (auto const& piece : outline.pieces) flatten_into(piece.curve, tolerance_px, contour);
  return contour;
}

bool is_shown(Layer const& layer) {
  return !layer.is_hidden && !layer.outlines.empty() && !layer.outlines.front().pieces.empty();
}

Drawing shown(Drawing drawing) {
  std::erase_if(drawing.layers, [](Layer const& layer) { return !is_shown(layer); });
  return drawing;
}

Sketch shown_sketch(Drawing const& drawing) {
  auto sketch = drawing.sketch;
  std::vector<bool> is_hidden(sketch.strokes.size());
  for (auto const& layer : drawing.layers) {
    if (!layer.is_hidden) continue;
    for (auto const* strokes : {&layer.strokes, &layer.details, &layer.noise}) {
      for (int const stroke : *strokes) is_hidden[stroke] = true;
    }
  }
  sketch.strokes.clear();
  for (std::size_t i = 0; i < is_hidden.size(); ++i) {
    if (!is_hidden[i]) sketch.strokes.push_back(drawing.sketch.strokes[i]);
  }
  return sketch;
}

void duplicate_behind(Drawing& drawing, int layer) {
  auto copy = drawing.layers[layer];
  copy.name += " copy";
  copy.id = LayerId::None;
  auto& sketch = drawing.sketch;
  int const group = static_cast<int>(std::ssize(sketch.groups));
  sketch.groups.push_back({copy.name, copy.fill, copy.thickness});
  std::map<int, int> copies;
  auto const copy_stroke = [&](int& stroke) {
    if (stroke < 0) return;  // a source that is not known
    auto const [entry, is_new] =
        copies.try_emplace(stroke, static_cast<int>(std::ssize(sketch.strokes)));
    if (is_new) {
      auto own = sketch.strokes[stroke];
      own.group = group;
      sketch.strokes.push_back(std::move(own));
    }
    stroke = entry->second;
  };
  for (int& stroke : copy.strokes) copy_stroke(stroke);
  for (int& stroke : copy.details) copy_stroke(stroke);
  for (int& stroke : copy.noise) copy_stroke(stroke);
  for (auto& outline : copy.outlines) {
    for (auto& source : outline.sources) copy_stroke(source.stroke);
  }
  drawing.layers.insert(drawing.layers.begin(), std::move(copy));
}

std::vector<Run> runs(Outline const& outline, double tolerance_px) {
  auto const& pieces = outline.pieces;
  int const count = static_cast<int>(std::ssize(pieces));
  // Start where the kind changes, so that no run is cut in two by the outline's first point.
  int first = 0;
  for (int i = 0; i < count && first == 0; ++i) {
    if (pieces[i].kind != pieces[(i + count - 1) % count].kind) first = i;
  }
  std::vector<Run> result;
  for (int i = 0; i < count; ++i) {
    auto const& piece = pieces[(first + i) % count];
    if (result.empty() || result.back().kind != piece.kind) {
      result.push_back({piece.kind, {piece.curve.start()}});
    }
    flatten_into(piece.curve, tolerance_px, result.back().points);
  }
  return result;
}

}  // namespace inkflate
