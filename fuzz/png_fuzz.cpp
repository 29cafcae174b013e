// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ink/trace_scan.h"
#include "io/byte_order.h"
#include "io/png_crc.h"
#include "io/read_picture.h"

namespace {

void read_and_trace(std::span<std::byte const> file) {
  auto const picture = inkflate::read_picture(file);
  // Larger ones take the same way, only longer.
  if (!picture || picture->width > 256 || picture->height > 256) return;
  static_cast<void>(inkflate::trace_scan(*picture).has_value());
}

/// Chunks with wrong checksums are refused at once; with right ones, what is in them gets read.
void repair_checksums(std::span<std::byte> file) {
  std::size_t offset = 8;
  while (offset + 12 <= file.size()) {
    std::size_t const length = inkflate::big_endian32(file.subspan(offset));
    if (length > file.size() - offset - 12) return;
    auto const crc = inkflate::png_crc(file.subspan(offset + 4, length + 4));
    for (std::size_t i = 0; i < 4; ++i) {
      file[offset + 8 + length + i] = static_cast<std::byte>(crc >> (24 - 8 * i));
    }
    offset += length + 12;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const input = std::as_bytes(std::span(data, size));
  read_and_trace(input);
  std::vector<std::byte> repaired(input.begin(), input.end());
  repair_checksums(repaired);
  read_and_trace(repaired);
  return 0;
}
