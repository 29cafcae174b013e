// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/affine.h"
#include "geometry/rect.h"
#include "model/rest_model.h"
#include "render/draw_model.h"

namespace inkflate {

/// Where a model stands in a view: its own space turned, moved and scaled.
struct ModelPlacement {
  // The directions of the view in the model's space.
  Vec3 right = {1, 0, 0};
  Vec3 up = {0, 1, 0};
  Vec3 to_viewer = {0, 0, 1};
  double scale = 1;
  Vec3 centre;  // of the turned model's box, which comes to the middle of the view
  Vec2 pan_px;  // right and up
  Rect box;     // of the model in the view; empty: a model without points

  /// A direction of the model as one of the view.
  Vec3 turned(Vec3 p) const { return {dot(right, p), dot(up, p), dot(to_viewer, p)}; }
  /// A point of the model as draw_model places it: px of the view, its centre is the origin, x to the right, y up, z towards the viewer.
  Vec3 operator()(Vec3 p) const {
    return scale * (turned(p) - centre) + Vec3{pan_px.x, pan_px.y, 0};
  }
};

/// What of a model is fitted into a view.
enum class ModelFit {
  AsTurned,  // what is seen fills the view: for pictures
  FromFront,  // its front would: the model keeps its size and turns about its middle, as a thing in the hand does
};

/// The model from one side, fitted into a view of this size: as turned, what draw_model draws.
///
/// cost    O(vertices)
ModelPlacement model_placement(RestModel const& model, ModelView const& view, double width_px,
                               double height_px, ModelFit fit = ModelFit::AsTurned);

/// A map of space, 3 x 4, row by row.
using SpaceMap = std::array<double, 12>;

/// From the model to px of a view of this size: origin top left, x to the right, y down, z towards the viewer.
SpaceMap to_view(ModelPlacement const& placement, double width_px, double height_px);

/// The same for the model lying on the paper where it was drawn, pressed flat; what lies nearer stays nearer by a little.
SpaceMap onto_paper(RestModel const& model, Affine const& canvas_to_view);

/// The soft shadow under a model: an ellipse.
struct ShadowEllipse {
  Vec2 centre;        // px of the picture, origin top left, y down
  Vec2 half_axes_px;  // > 0
};

/// in      box: of the model in the view, as ModelPlacement has it; not empty
ShadowEllipse shadow_ellipse(Rect const& box, double width_px, double height_px);

}  // namespace inkflate
