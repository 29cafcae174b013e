// SPDX-License-Identifier: Apache-2.0
#include "image/morphology.h"

#include <algorithm>
#include <cstdint>

namespace inkflate {
namespace {

/// out[i] = a[i] op b[i] op c[i]; plain loops over bytes, which compilers turn into vector code.
template <class Operation>
void combine(std::uint8_t const* a, std::uint8_t const* b, std::uint8_t const* c, int count,
             std::uint8_t* out, Operation operation) {
  for (int i = 0; i < count; ++i) out[i] = operation(operation(a[i], b[i]), c[i]);
}

/// Rows first, then columns: the square is the sum of a horizontal and a vertical bar.
template <class Operation>
Mask combine_3x3(Mask const& mask, Operation operation) {
  int const width = mask.width;
  int const height = mask.height;
  // One pixel of background on all sides.
  Mask padded(width + 2, height + 2);
  Mask rows(width, height + 2);
  for (int y = 0; y < height; ++y) {
    auto const* const from = mask.values.data() + static_cast<std::ptrdiff_t>(y) * width;
    std::copy(from, from + width,
              padded.values.data() + static_cast<std::ptrdiff_t>(y + 1) * (width + 2) + 1);
  }
  for (int y = 0; y < height + 2; ++y) {
    auto const* const row = padded.values.data() + static_cast<std::ptrdiff_t>(y) * (width + 2);
    combine(row, row + 1, row + 2, width,
            rows.values.data() + static_cast<std::ptrdiff_t>(y) * width, operation);
  }
  Mask result(width, height);
  for (int y = 0; y < height; ++y) {
    auto const* const row = rows.values.data() + static_cast<std::ptrdiff_t>(y) * width;
    combine(row, row + width, row + 2 * static_cast<std::ptrdiff_t>(width), width,
            result.values.data() + static_cast<std::ptrdiff_t>(y) * width, operation);
  }
  return result;
}

}  // namespace

Mask erode_3x3(Mask const& mask) {
  return combine_3x3(mask, [](std::uint8_t a, std::uint8_t b) -> std::uint8_t { return a & b; });
}

Mask dilate_3x3(Mask const& mask) {
  return combine_3x3(mask, [](std::uint8_t a, std::uint8_t b) -> std::uint8_t { return a | b; });
}

}  // namespace inkflate
