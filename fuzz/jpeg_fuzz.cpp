// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <span>

#include "ink/trace_scan.h"
#include "io/read_picture.h"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const picture = inkflate::read_picture(std::as_bytes(std::span(data, size)));
  // Larger ones take the same way, only longer.
  if (!picture || picture->width > 256 || picture->height > 256) return 0;
  static_cast<void>(inkflate::trace_scan(*picture).has_value());
  return 0;
}
