// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deform/bend_mesh.h"

namespace inkflate::support {

/// A straight bar from (0, 0) along x, its middle at y = 0; vertices column by column. With an even number of rows it is its own mirror
/// image above and below.
BendMesh bar_mesh(double length_px, double width_px, int columns, int rows);

/// A figure of about 600 x 820 px with a head, two arms and two legs, and about that many points along its contour of 3600 px.
BendMesh figure_mesh(int contour_points);

/// The vertex of a mesh that is nearest to a place.
int nearest_vertex(FlatMesh const& mesh, Vec2 place);

/// A vertex as an anchor.
BendAnchor anchor_of(FlatMesh const& mesh, int vertex);

/// The vertex that is nearest to a place, as an anchor.
BendAnchor anchor_near(BendMesh const& mesh, Vec2 place);

/// How far the vertex that moved farthest is in one pose from where it is in another.
double largest_distance(BendPose const& a, BendPose const& b);

/// The vertices of several meshes in one, none joined to another.
BendMesh side_by_side(BendMesh const& a, BendMesh const& b);

}  // namespace inkflate::support
