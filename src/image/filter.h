// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"

namespace inkflate {

/// The picture over white paper, every pixel opaque.
Picture over_white(Picture picture);

/// The picture at a smaller size, each pixel the mean of the area that it covers; alpha as one more channel.
/// width, height: 1 .. those of the picture. O(pixels).
Picture shrink(Picture const& picture, int width, int height);

/// The largest and the smallest value in the square of 2 radius + 1 pixels around each pixel, cut off at the border.
/// O(pixels * radius).
Mask local_maximum(Mask const& values, int radius);
Mask local_minimum(Mask const& values, int radius);

/// The mean over the square of 2 radius + 1 pixels, cut off at the border. O(pixels).
Grid2<double> box_mean(Grid2<double> const& values, int radius);

/// Weights 1 2 1 in both directions, rounded: takes most of a camera's noise and little of a pen's edge.
Mask soften(Mask const& values);

}  // namespace inkflate
