// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/vec2.h"

namespace inkflate::cli {

/// A finite decimal number and nothing else.
std::optional<double> parse_number(std::string_view text);

struct PictureSize {
  int width = 0;
  int height = 0;
};

/// "N" for a square or "WxH", each 1 to 16384 px and at most 64 megapixels together. BadOption names the option and the text.
Result<PictureSize> parse_picture_size(std::string_view option, std::string_view text);

/// "X,Y", both finite. BadOption names the option and the text.
Result<Vec2> parse_point(std::string_view option, std::string_view text);

/// Every text as a point.
Result<std::vector<Vec2>> parse_points(std::string_view option,
                                       std::vector<std::string> const& texts);

}  // namespace inkflate::cli
