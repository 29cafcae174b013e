// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/draw_list.h"

namespace inkflate {

/// The drawn pieces of a dashed line, each solid; the line itself when it has no dashes. A dash of length 0 becomes a
/// line of one point: a dot.
std::vector<StrokedPolyline> dashes(StrokedPolyline const& line);

}  // namespace inkflate
