// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "deform/line_samples.h"
#include "deform/shape_mesh.h"

namespace inkflate {

/// The length of edges along the rims of a shape where it is wide: a four-hundredth of its rims, but no finer than 6 px of a character
/// that is 1000 px wide. It grows with the shape, so that a small drawing is bent as finely as a large one.
double rim_edge_px(std::span<Outline const> outlines);

/// The outlines as they are meshed: about so far apart, closer where the shape is thin. Vertices lie on the curves.
/// in      edge_px: > 0
/// out     one per outline; fewer than three points where it is no area
std::vector<LineSamples> sample_rims(std::span<Outline const> outlines, double edge_px);

/// The area of outlines, filled with triangles: stiffness 1 along the rims and `body` inside.
///
/// in      outlines: the outer one first, then the holes; at least one. least_edge_px: edges along the rims are as long as this where
///         that is no more than four times as long as they would be
/// out     nothing where the outer outline has no area, or crosses itself however finely it is sampled and is no rim of a disk, or has holes
///         then. A disk that lies over itself is filled sheet by sheet (deform/cut_sheets.h). Holes that cross something are left out, and
///         filled
/// cost    about 3 ms for rims of 400 points
std::optional<ShapeMesh> body_mesh(std::span<Outline const> outlines, double body,
                                   double least_edge_px = 0);

}  // namespace inkflate
