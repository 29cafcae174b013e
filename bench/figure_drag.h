// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deform/bend_mesh.h"
#include "geometry/polyline.h"
#include "model/drawing.h"

namespace inkflate {

/// The contour of tests/support's figure (head, arms, legs; 3600 px around) by so many points.
Contour figure_contour(int points);

/// The same, straight from point to point.
Outline figure_outline(int points);

/// What holds a mesh of the figure when this share of the drag is done: a foot and a hip are pinned, the tip of an arm is dragged by 155 px up
/// and towards the head. All at vertices; the dragged one last.
std::vector<BendHandle> figure_handles(BendMesh const& mesh, double share);

/// A pin on the other arm, at rest.
BendHandle figure_pin(BendMesh const& mesh);

/// How far the points of the head, each limb and the trunk are from the rigid motion of that part that fits best, on the
/// average, px. rest, now: the same points along the figure's contour.
double figure_shape_error(std::span<Vec2 const> rest, std::span<Vec2 const> now);

/// Where rigid moving least squares take a place when the places `from` go to `to`, with weights 1 / distance^2.
/// source  Schaefer, McPhail, Warren 2006, "Image Deformation Using Moving Least Squares", section 2.3
Vec2 moved_by_least_squares(Vec2 place, std::span<Vec2 const> from, std::span<Vec2 const> to);

}  // namespace inkflate
