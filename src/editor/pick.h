// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "document/document.h"
#include "editor/tool.h"
#include "editor/view.h"

namespace inkflate {

enum class PickDepth { Nearest, Farthest };

/// The layer under a place of the canvas: inside its outlines, or within reach_px of its rim. Hidden and locked ones cannot be picked. None:
/// there is none.
LayerId pick_layer(Document const& document, Vec2 canvas, double reach_px, PickDepth depth);

/// Layers whose boxes touch a box.
std::vector<LayerId> layers_in(Document const& document, Rect const& box);

/// Of outlines; of strokes where there are none.
Rect layer_box(DocumentLayer const& layer);
Rect box_of(Document const& document, std::vector<LayerId> const& layers);
/// Of everything that is visible, loose strokes too.
Rect box_of(Document const& document);

/// The frame around the selection that can be held to move, scale and turn it; screen px, handles included.
struct Frame {
  Rect box;                                           // canvas px
  std::vector<std::pair<FrameHandle, Vec2>> handles;  // screen px
};
std::optional<Frame> selection_frame(Document const& document, View const& view);
std::optional<FrameHandle> pick_handle(Frame const& frame, View const& view, Vec2 screen);

/// Rough strokes whose line passes within radius_px of a stretch.
std::vector<StrokeRef> strokes_near(Document const& document, Vec2 from, Vec2 to, double radius_px);

}  // namespace inkflate
