// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "base/result.h"

namespace inkflate::detail {

/// How a camera held the picture: EXIF's numbers 1 (upright) to 8.
enum class Orientation {
  Upright = 1,
  Mirrored = 2,
  UpsideDown = 3,
  MirroredUpsideDown = 4,
  Transposed = 5,
  TurnedLeft = 6,  // turn it clockwise to see it upright
  Transversed = 7,
  TurnedRight = 8,
};

struct JpegHeaders {
  int width = 0;
  int height = 0;
  int components = 0;
  int scans = 0;
  bool is_progressive = false;
  Orientation orientation = Orientation::Upright;
};

/// Walks over all markers of a JPEG without decoding, so that limits can be checked and a file that is cut off is found.
/// errors  BadInput, Unsupported (lossless, arithmetic, hierarchical, 12 bit)
Result<JpegHeaders> read_jpeg_headers(std::span<std::byte const> file);

/// The orientation in the payload of an APP1 segment; Upright where there is none or it makes no sense.
Orientation exif_orientation(std::span<std::byte const> payload);

}  // namespace inkflate::detail
