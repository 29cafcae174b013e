// SPDX-License-Identifier: Apache-2.0
#include "io/read_svg.h"

#include <string_view>
#include <utility>

#include "io/own_svg.h"
#include "io/svg_tree.h"
#include "io/svg_walk.h"

namespace inkflate {

Result<SvgReading> read_svg_with_warnings(std::span<std::byte const> bytes) {
  std::string_view const document(reinterpret_cast<char const*>(bytes.data()), bytes.size());
  if (document.substr(0, 2) == "\x1f\x8b") {
    return Error{ErrorCode::Unsupported, "the SVG is compressed; unpack the .svgz first", 0};
  }
  auto const tree = read_svg_tree(document);
  if (!tree) return tree.error();
  if (!is_own_svg(*tree)) return SvgWalk(*tree).run();
  auto own = read_own_svg(*tree);
  if (!own) return own.error();
  return SvgReading{std::move(*own), {}};
}

Result<Drawing> read_svg(std::span<std::byte const> bytes) {
  auto reading = read_svg_with_warnings(bytes);
  if (!reading) return reading.error();
  return std::move(reading->drawing);
}

}  // namespace inkflate
