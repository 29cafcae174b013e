// SPDX-License-Identifier: Apache-2.0
#include "editor/bend_reach.h"

#include <algorithm>

#include "assemble/joined_runs.h"
#include "editor/pick.h"

namespace inkflate {
namespace {

bool is_open_run(OutlinePiece const& piece) { return piece.kind != RunKind::Ink; }

bool has_open_run(Layer const& layer) {
  return std::any_of(layer.outlines.begin(), layer.outlines.end(), [](Outline const& outline) {
    return std::any_of(outline.pieces.begin(), outline.pieces.end(), is_open_run);
  });
}

/// Whether a layer joins another by an open run.
bool is_joined(Document const& document, Layer const& layer) {
  // The search looks at the whole drawing.
  if (!has_open_run(layer)) return false;
  auto const drawing = shown_drawing(document);
  auto const runs = joined_runs(drawing);
  return std::any_of(runs.begin(), runs.end(), [&](JoinedRun const& run) {
    return drawing.layers[static_cast<std::size_t>(run.limb)].id == layer.id;
  });
}

bool is_held(Document const& document, LayerId id) {
  auto const* const layer = find_layer(document, id);
  return layer != nullptr && (!layer->layer.bend_pins.empty() || is_joined(document, layer->layer));
}

Rect box_of(Document const& document, BendGrab const& what) {
  auto const* const layer = find_layer(document, what.stroke ? what.stroke->layer : what.layer);
  if (!what.stroke) return layer == nullptr ? Rect{} : layer_box(*layer);
  auto const& strokes = layer == nullptr ? document.loose : layer->strokes;
  return strokes[what.stroke->index]->box;
}

}  // namespace

double bend_share(Document const& document, BendGrab const& what, ToolSettings const& settings) {
  if (settings.bend_reach) return *settings.bend_reach;
  return is_held(document, what.layer) ? 1 : kUsualBendReach;
}

BendReach bend_reach(Document const& document, BendGrab const& what, double share) {
  auto const box = box_of(document, what);
  // What has no extent has no part of itself.
  bool const is_whole = share >= 1 || box.is_empty() || !(box.longer_side() > 0);
  return is_whole ? BendReach{} : BendReach{share * box.longer_side()};
}

}  // namespace inkflate
