// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "render/rasterise.h"

namespace inkflate {

/// Boxes side by side without overlap.
struct Shelves {
  int width = 0;
  int height = 0;
  std::vector<PixelBox> boxes;  // in the order of the sizes asked for
};

struct PixelSize {
  int width = 0;
  int height = 0;
};

/// Puts boxes on shelves, the tallest first, so that the whole is about as wide as high.
///
/// in      sizes: each side 0 .. 16384
/// cost    O(n log n)
Shelves pack_shelves(std::span<PixelSize const> sizes);

}  // namespace inkflate
