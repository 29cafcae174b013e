// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "document/document.h"
#include "editor/tool.h"
#include "editor/view.h"

namespace inkflate {

enum class PickDepth { Nearest, Farthest };

/// Hidden and locked layers cannot be picked.
bool is_pickable(DocumentLayer const& layer);

/// Whether a layer lies under a place of the canvas: inside its outlines, or within reach_px of its rim, or of its strokes while it is
/// open.
bool is_under(DocumentLayer const& layer, Vec2 canvas, double reach_px);

/// The layer under a place of the canvas, of those that can be picked. None: there is none.
LayerId pick_layer(Document const& document, Vec2 canvas, double reach_px, PickDepth depth);

/// Layers whose boxes touch a box, of those that can be picked; ascending.
std::vector<LayerId> layers_in(Document const& document, Rect const& box);

/// Of outlines; of strokes where there are none.
Rect layer_box(DocumentLayer const& layer);
Rect box_of(Document const& document, std::vector<LayerId> const& layers);
/// Of everything that is visible, loose strokes too.
Rect box_of(Document const& document);

/// Those of the layers that exist and can be picked; ascending.
std::vector<LayerId> pickable(Document const& document, std::vector<LayerId> const& layers);

/// The frame around the selection that can be held to move, scale and turn it. Handles are named by the side of the canvas that they
/// move: in a mirrored view Left is to the right.
struct Frame {
  Rect box;                                           // canvas px
  std::vector<std::pair<FrameHandle, Vec2>> handles;  // screen px
};
/// Nothing: no layer is selected that can be picked, or those have no extent.
std::optional<Frame> selection_frame(Document const& document, View const& view);
/// Nothing: the place is outside. Inside comes first where a box is so small that its handles would leave no room to hold it.
std::optional<FrameHandle> pick_handle(Frame const& frame, View const& view, Vec2 screen);

/// Strokes of a list whose line passes within radius_px of a stretch; indices, ascending.
std::vector<int> strokes_near(StrokeList const& strokes, Vec2 from, Vec2 to, double radius_px);
/// The same for rough strokes: the loose ones, then those of layers that take strokes, back to front.
std::vector<StrokeRef> strokes_near(Document const& document, Vec2 from, Vec2 to, double radius_px);

}  // namespace inkflate
