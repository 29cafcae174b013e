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

/// Estimates the paper under a drawing, shadows and all, and divides by it. Opaque picture of at least one pixel.
FlatScan flatten_paper(Picture const& picture);

/// Whether light lines lie on a dark ground.
bool is_drawn_on_dark(Picture const& picture);

/// Black for white and back; hues stay.
Picture with_lightness_turned(Picture picture);

}  // namespace inkflate
