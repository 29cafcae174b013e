// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/drawing.h"
#include "model/rest_model.h"

namespace inkflate {

enum class OutlineLook {
  Rough,  // the strokes as they were drawn
  Clean,  // one line all along the rim where front and back meet, in the strokes' mean colour and width
};

enum class BackDetails {
  Hidden,  // no face on the back of a head
  Shown,
};

struct BakeOptions {
  double texels_per_px = 1.5;  // > 0: per canvas px; fewer where the picture would become too large
  int longest_side = 2048;     // 64 .. 16384 texels
  int padding = 8;  // 0 .. 64 texels between a layer's bounding box and the border of its rectangle
  OutlineLook outline = OutlineLook::Clean;
  BackDetails back_details = BackDetails::Hidden;
};

/// Draws the drawing for the model to wear: a rectangle for each sheet of each layer, filled whole with the layer's
/// colour, its own strokes over it in drawing order. Both sheets share one where they look the same.
///
/// in      model: made from this drawing; layer i of its faces is layer i of the drawing. Layers that the drawing lacks
///         are plain
/// out     no triangle comes nearer than `padding` to the border of its rectangle
/// cost    about 10 ms for 5 layers of 1000 px; memory: the picture, at most 17 MB by default, and 2 MB
/// source  docs/algorithms/render.md
Texture bake_texture(Drawing const& drawing, RestModel const& model,
                     BakeOptions const& options = {});

/// One picture that lies on front and back alike, on the canvas as large as fits and centred: a template to colour in, a photograph.
/// Beyond it the model wears its border. picture: at least one pixel
Texture wear_picture(Picture picture, RestModel const& model);

}  // namespace inkflate
