// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "model/stroke.h"

namespace inkflate {

struct Pen {
  double width_px = 0;
  Colour colour;
};

/// Width (as the pen was pressed) and colour that strokes have on average, each counting once; help lines and colours' alpha do not count. None: there is no ink.
std::optional<Pen> mean_pen(std::vector<Stroke const*> const& strokes);

}  // namespace inkflate
