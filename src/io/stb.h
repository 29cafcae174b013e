// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace inkflate::detail {

struct FreeMemory {
  void operator()(std::uint8_t* memory) const;
};

/// RGB bytes, row by row. No pixels: the decoder refused the data or had no memory.
struct DecodedJpeg {
  int width = 0;
  int height = 0;
  std::unique_ptr<std::uint8_t, FreeMemory> rgb;
};

/// The caller has checked size, scans and memory by the headers.
DecodedJpeg decode_jpeg(std::span<std::byte const> file);

/// A whole zlib stream; the same bytes on every machine. At most 1.5 GB of data.
std::vector<std::byte> compress_zlib(std::span<std::byte const> data);

}  // namespace inkflate::detail
