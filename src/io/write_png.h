// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "image/grid2.h"

namespace inkflate {

/// A PNG with RGB pixels of 8 bits, or RGBA where one is not opaque; the same bytes for the same picture on every machine. At least one pixel, at most
/// 64 megapixels.
std::vector<std::byte> write_png(Picture const& picture);

/// A PNG with grey pixels of 8 bits.
std::vector<std::byte> write_png(Mask const& mask);

}  // namespace inkflate
