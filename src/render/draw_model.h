// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "model/rest_model.h"

namespace inkflate {

enum class Shading {
  Matcap,    // warm clay
  Textured,  // the texture under a soft light
  Lines,     // paper white with ink where the surface ends or folds
};

/// From where a model is looked at. Parallel rays, no perspective.
struct ModelView {
  double turn_rad = 0;  // the viewer walks around it, to the right
  double tilt_rad = 0;  // the viewer rises above it
  double zoom = 1;      // > 0; 1: it fills the picture but for a margin
  Vec2 pan_px;          // moves it right and down
};

/// Triangles to be drawn with depth, ready for a GPU or our own rasteriser. Space of the view: px of the picture, its
/// centre is the origin, x to the right, y up, z towards the viewer.
struct DrawTriangles {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  // of length 1, one per position
  std::vector<Triangle> triangles;
  std::vector<std::array<Vec2, 3>> corners;  // per triangle its places on the texture; empty: none
  Picture const* texture = nullptr;          // has to outlive the list; none: not textured
  Shading shading = Shading::Matcap;
};

/// A model from one side, fitted into a picture of this size.
///
/// in      texture: for Shading::Textured; without one the model is drawn as clay
/// cost    O(vertices + triangles)
DrawTriangles draw_model(RestModel const& model, Texture const* texture, ModelView const& view,
                         Shading shading, int width, int height);

}  // namespace inkflate
