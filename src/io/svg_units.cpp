// SPDX-License-Identifier: Apache-2.0
#include "io/svg_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/trig.h"
#include "io/numbers.h"
#include "model/stroke.h"

namespace inkflate {
namespace {

constexpr double kPxPerInch = 96;
constexpr double kEmPx = 16;

struct Arguments {
  std::array<double, 6> values = {};
  int count = 0;
};

// "(1, 2 3)" off the front of the text.
std::optional<Arguments> take_arguments(std::string_view& text) {
  skip_separator(text, Separator::Blank);
  if (text.empty() || text.front() != '(') return std::nullopt;
  text.remove_prefix(1);
  Arguments arguments;
  skip_separator(text, Separator::Blank);
  while (!text.empty() && text.front() != ')') {
    auto const number = take_number(text);
    if (!number || !std::isfinite(*number) || arguments.count == 6) return std::nullopt;
    arguments.values[static_cast<std::size_t>(arguments.count++)] = *number;
    skip_separator(text, Separator::Comma);
  }
  if (text.empty()) return std::nullopt;
  text.remove_prefix(1);
  return arguments;
}

SinCos sin_cos_degrees(double degrees) {
  double const turn = degrees - 360 * std::floor(degrees / 360);
  return sin_cos(turn * (kPi / 180));
}

Affine rotation(double degrees, Vec2 centre) {
  auto const [s, c] = sin_cos_degrees(degrees);
  return Affine::translation(centre) * Affine{c, s, -s, c, 0, 0} * Affine::translation(-centre);
}

double tangent(double degrees) {
  auto const [s, c] = sin_cos_degrees(degrees);
  return s / c;
}

std::optional<Affine> transform_function(std::string_view name, Arguments const& arguments) {
  auto const& v = arguments.values;
  int const count = arguments.count;
  if (name == "matrix" && count == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (count == 1 || count == 2)) return Affine::translation({v[0], v[1]});
  if (name == "scale" && (count == 1 || count == 2)) {
    return Affine::scaling(v[0], count == 2 ? v[1] : v[0]);
  }
  if (name == "rotate" && (count == 1 || count == 3)) return rotation(v[0], {v[1], v[2]});
  if (name == "skewX" && count == 1) return Affine{1, 0, tangent(v[0]), 1, 0, 0};
  if (name == "skewY" && count == 1) return Affine{1, tangent(v[0]), 0, 1, 0, 0};
  return std::nullopt;
}

}  // namespace

std::optional<double> length_px(std::string_view text, double percent_base) {
  text = trimmed(text);
  auto const number = take_number(text);
  if (!number) return std::nullopt;
  std::pair<std::string_view, double> const units[] = {
      {"", 1},
      {"px", 1},
      {"mm", kPxPerInch / 25.4},
      {"cm", kPxPerInch / 2.54},
      {"in", kPxPerInch},
      {"pt", kPxPerInch / 72},
      {"pc", kPxPerInch / 6},
      {"em", kEmPx},
      {"rem", kEmPx},
      {"ex", kEmPx / 2},
      {"%", percent_base / 100},
  };
  auto const unit = lower_ascii(text.substr(0, 4));
  for (auto const& [name, factor] : units) {
    double const length = *number * factor;
    if (unit == name && std::isfinite(length)) return length;
  }
  return std::nullopt;
}

std::optional<double> parse_thickness(std::string_view text) {
  text = trimmed(text);
  auto const number = take_number(text);
  bool const is_legal = number && text.empty() && *number >= kLeastThickness &&
                        *number <= kLargestThickness;  // false for NaN too
  return is_legal ? number : std::nullopt;
}

std::optional<Affine> parse_transform(std::string_view text) {
  Affine result;
  text = trimmed(text);
  if (text == "none") return result;
  while (!text.empty()) {
    auto const size = std::min(text.find_first_of("( \t\r\n"), text.size());
    auto const name = text.substr(0, size);
    text.remove_prefix(size);
    auto const arguments = take_arguments(text);
    auto const function = arguments ? transform_function(name, *arguments) : std::nullopt;
    if (!function) return std::nullopt;
    result = result * *function;
    skip_separator(text, Separator::Comma);
  }
  return result;
}

std::optional<ViewBox> parse_view_box(std::string_view text) {
  std::array<double, 4> values = {};
  skip_separator(text, Separator::Blank);
  for (double& value : values) {
    auto const number = take_number(text);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    value = *number;
    skip_separator(text, Separator::Comma);
  }
  if (!(values[2] > 0) || !(values[3] > 0)) return std::nullopt;
  return ViewBox{{values[0], values[1]}, {values[2], values[3]}};
}

Affine fit_view_box(ViewBox const& box, Vec2 size_px, std::string_view preserve_aspect_ratio) {
  Vec2 scale = {size_px.x / box.size.x, size_px.y / box.size.y};
  auto const has = [&](std::string_view word) {
    return preserve_aspect_ratio.find(word) != std::string_view::npos;
  };
  if (has("none")) {
    return Affine::scaling(scale.x, scale.y) * Affine::translation(-box.min);
  }
  double const factor = has("slice") ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
  // The middle unless said otherwise.
  auto const share = [&](std::string_view low, std::string_view high) {
    return has(low) ? 0.0 : has(high) ? 1.0 : 0.5;
  };
  Vec2 const rest = size_px - box.size * factor;
  Vec2 const shift = {rest.x * share("xMin", "xMax"), rest.y * share("YMin", "YMax")};
  return Affine::translation(shift) * Affine::scaling(factor, factor) *
         Affine::translation(-box.min);
}

}  // namespace inkflate
