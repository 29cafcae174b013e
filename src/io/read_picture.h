// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "base/result.h"
#include "image/grid2.h"

namespace inkflate {

/// What a picture may ask for; checked by its headers, before memory is taken.
struct PictureLimits {
  static constexpr long long kFileBytes = 64LL << 20U;
  static constexpr long long kSidePx = 16384;
  static constexpr long long kPixels = 64'000'000;
  static constexpr long long kDecoderBytes = 512LL << 20U;
  static constexpr long long kJpegScanPixels = 1'000'000'000;  // scans x pixels
};

/// Whether the file starts as a PNG or a JPEG does.
bool is_picture(std::span<std::byte const> file);

/// Reads a PNG (every kind of the specification) or a JPEG (baseline or progressive, 8 bit), by the file's content.
///
/// in      file: the whole file
/// out     sRGB with straight alpha, upright: a JPEG's EXIF orientation is applied. Colour profiles and gamma are
///         ignored; 16-bit samples keep their upper half
/// errors  BadInput (damaged, or cut off: the index is the byte), Unsupported (neither format, or a kind of it that
///         nobody uses), TooLarge (PictureLimits)
/// cost    about 25 ns per pixel; memory: PNG 4 bytes per pixel, JPEG at most kDecoderBytes
/// source  PNG specification (W3C, second edition); ITU T.81 annex B; EXIF 2.3 section 4.6
Result<Picture> read_picture(std::span<std::byte const> file);

}  // namespace inkflate
