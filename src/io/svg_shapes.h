// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec2.h"
#include "io/path_tracer.h"
#include "io/svg_tree.h"

namespace inkflate {

bool is_shape(std::string_view element_name);

/// Draws a path, polyline, polygon, line, rect, circle or ellipse. viewport_size is what percentages mean.
/// False: its data is damaged, and what stands before the damage was drawn.
bool trace_shape(SvgElement const& element, Vec2 viewport_size, PathTracer& tracer);

/// What 100 % means for lengths that are neither widths nor heights.
double viewport_diagonal(Vec2 viewport_size);

}  // namespace inkflate
