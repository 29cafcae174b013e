// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"

namespace inkflate {

/// A drawing in even light.
struct FlatScan {
  Picture colour;  // relative to the paper: white where there is none but paper
  Mask
      strength;  // 0 paper .. 255: how much darker than the paper in the channel that differs most; softened
};

/// Estimates the paper under a drawing, shadows and all, and divides by it. Opaque picture of at least one pixel;
/// sheet: as find_sheet gives it; where it is 0 the result is white.
FlatScan flatten_paper(Picture const& picture, Mask const& sheet);

/// Whether light lines lie on a dark ground, on the sheet.
bool is_drawn_on_dark(Picture const& picture, Mask const& sheet);

/// Black for white and back; hues stay.
Picture with_lightness_turned(Picture picture);

}  // namespace inkflate
