// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/polyline.h"
#include "model/drawing.h"

namespace inkflate {

/// Sketches for tests, built in code. Angles in radians, lengths in px.

/// A stroke straight from point to point.
Stroke line_stroke(std::vector<Vec2> const& points, StrokeKind kind = StrokeKind::Ink);

/// A part of an ellipse, clockwise on the screen from one angle to another; a whole turn is closed.
Stroke arc_stroke(Vec2 centre, double radius_x, double radius_y, double from_rad, double to_rad,
                  StrokeKind kind = StrokeKind::Ink);

Stroke circle_stroke(Vec2 centre, double radius);

/// A stroke over points drawn `passes` times, each pass moved aside a little more: 0, aside_px, 2 aside_px, ...
std::vector<Stroke> overdrawn(Stroke const& stroke, int passes, Vec2 aside_px);

/// 1000 x 1000 px.
Sketch sketch_of(std::vector<Stroke> strokes);

/// A random rough drawing: blobs of a few kinds in overlapping passes with gaps and jitter, loose lines, dots, hatching. Also
/// nasty ones: equal points, huge and tiny coordinates, nothing at all.
Sketch random_sketch(std::uint64_t seed);

/// Every piece starts where the one before ends, every polygon of it is simple, outer ones first and positive, holes negative and
/// inside; every stroke is in one place. Says what is wrong; empty: nothing.
std::string what_is_wrong(Drawing const& drawing);

}  // namespace inkflate
