// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/read_picture.h"

namespace inkflate::detail {

/// The PNG part of read_picture. Wrong checksums of critical chunks are refused, those of ancillary ones ignored.
Result<Picture> read_png(std::span<std::byte const> file);

/// An error when a picture of this size is over a limit or has no pixels.
Result<bool> check_picture_size(long long width, long long height);

}  // namespace inkflate::detail
