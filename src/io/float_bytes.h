// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>

#include "io/byte_order.h"

namespace inkflate {

/// A number of single precision, lowest byte first; the caller has checked that the bytes are there.
inline double little_endian_float32(std::span<std::byte const> bytes) {
  std::uint32_t const bits = little_endian32(bytes);
  float number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

}  // namespace inkflate
