// SPDX-License-Identifier: Apache-2.0
#include "editor/bend_reach.h"

#include <algorithm>

#include "editor/pick.h"

namespace inkflate {
namespace {

bool is_open_run(OutlinePiece const& piece) { return piece.kind != RunKind::Ink; }

bool has_open_run(Layer const& layer) {
  return std::any_of(layer.outlines.begin(), layer.outlines.end(), [](Outline const& outline) {
    return std::any_of(outline.pieces.begin(), outline.pieces.end(), is_open_run);
  });
}

/// The session's search looks at the whole drawing, where it has not met it.
bool is_held(Document const& document, LayerId id, BendSession& session) {
  auto const* const layer = find_layer(document, id);
  if (layer == nullptr) return false;
  if (!layer->layer.bend_pins.empty()) return true;
  return has_open_run(layer->layer) && session.is_limb(document, id);
}

Rect box_of(Document const& document, BendGrab const& what) {
  auto const* const layer = find_layer(document, what.stroke ? what.stroke->layer : what.layer);
  if (!what.stroke) return layer == nullptr ? Rect{} : layer_box(*layer);
  auto const& strokes = layer == nullptr ? document.loose : layer->strokes;
  return strokes[what.stroke->index]->box;
}

}  // namespace

double usual_bend_reach(BendMode mode) { return mode == BendMode::Wire ? 0.3 : 0.6; }

double usual_share(Document const& document, LayerId layer, BendMode mode, BendSession& session) {
  return is_held(document, layer, session) ? 1 : usual_bend_reach(mode);
}

double bend_share(Document const& document, BendGrab const& what, ToolSettings const& settings,
                  BendSession& session) {
  if (settings.bend_reach) return *settings.bend_reach;
  return usual_share(document, what.layer, settings.bend_mode, session);
}

BendReach bend_reach(Document const& document, BendGrab const& what, double share) {
  auto const box = box_of(document, what);
  // What has no extent has no part of itself.
  bool const is_whole = share >= 1 || box.is_empty() || !(box.longer_side() > 0);
  return is_whole ? BendReach{} : BendReach{share * box.longer_side()};
}

}  // namespace inkflate
