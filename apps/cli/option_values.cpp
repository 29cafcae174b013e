// SPDX-License-Identifier: Apache-2.0
#include "cli/option_values.h"

#include <charconv>
#include <cmath>

#include "io/read_picture.h"

namespace inkflate::cli {

std::optional<double> parse_number(std::string_view text) {
  double number = 0;
  char const* const end = text.data() + text.size();
  auto const [stopped, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stopped != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

Result<PictureSize> parse_picture_size(std::string_view option, std::string_view text) {
  auto const cross = text.find('x');
  auto const width = parse_number(text.substr(0, cross));
  auto const height =
      cross == std::string_view::npos ? width : parse_number(text.substr(cross + 1));
  auto const is_side = [](std::optional<double> side) {
    return side && *side >= 1 && *side <= PictureLimits::kSidePx && *side == std::floor(*side);
  };
  if (is_side(width) && is_side(height) && *width * *height <= PictureLimits::kPixels) {
    return PictureSize{static_cast<int>(*width), static_cast<int>(*height)};
  }
  return Error{ErrorCode::BadOption,
               std::string(option) +
                   " wants N or WxH, whole px up to 16384 and 64 megapixels, not " +
                   std::string(text)};
}

Result<Vec2> parse_point(std::string_view option, std::string_view text) {
  auto const comma = text.find(',');
  if (comma != std::string_view::npos) {
    auto const x = parse_number(text.substr(0, comma));
    auto const y = parse_number(text.substr(comma + 1));
    if (x && y) return Vec2{*x, *y};
  }
  return Error{ErrorCode::BadOption,
               std::string(option) + " wants a point like 120,80.5, not " + std::string(text)};
}

Result<std::vector<Vec2>> parse_points(std::string_view option,
                                       std::vector<std::string> const& texts) {
  std::vector<Vec2> points;
  for (auto const& text : texts) {
    auto const point = parse_point(option, text);
    if (!point) return point.error();
    points.push_back(*point);
  }
  return points;
}

}  // namespace inkflate::cli
