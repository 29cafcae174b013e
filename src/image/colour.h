// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace inkflate {

/// sRGB with straight (not premultiplied) alpha.
struct Colour {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;

  friend bool operator==(Colour const&, Colour const&) = default;
};

}  // namespace inkflate
