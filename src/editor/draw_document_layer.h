// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "document/document.h"
#include "render/draw_list.h"

namespace inkflate {

/// The draw lists of one layer, on the canvas. tolerance_px: how far lines may be from their curves.

/// A closed layer: its area, opaque, so that it hides what lies behind; details as they were drawn; outlines by their runs in the ink that they were drawn with.
DrawList draw_closed_layer(DocumentLayer const& layer, double tolerance_px);

/// The lines of a list once more, as faint as what shines through.
DrawList draw_hidden_ink(DrawList const& list);

/// The outlines that an open layer had, pale.
DrawList draw_stale_outlines(DocumentLayer const& layer, double tolerance_px);

enum class Highlight { Selected, Hovered };

/// A line of even width on the screen around the layer, with a halo that sets it off from anything; along its strokes where it has no outlines.
DrawList draw_highlight(DocumentLayer const& layer, Highlight highlight, double tolerance_px);

}  // namespace inkflate
