// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "io/path_tracer.h"

namespace inkflate {

/// Draws path data. False: the data is damaged, and everything before the damage has been drawn, as SVG asks.
/// source  SVG 1.1, chapter 8.3
bool trace_path(std::string_view data, PathTracer& tracer);

/// Draws the points of a polyline or polygon. False as above; an odd number at the end is damage.
enum class PointsEnd { Open, Closed };
bool trace_points(std::string_view points, PointsEnd end, PathTracer& tracer);

}  // namespace inkflate
