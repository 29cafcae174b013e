// SPDX-License-Identifier: Apache-2.0
#include "cli/read_sketch.h"

#include <utility>

#include "io/format.h"
#include "io/read_picture.h"
#include "io/read_scap.h"
#include "io/read_svg.h"

namespace inkflate::cli {
namespace {

template <typename Value>
Result<ReadSketch> without_warnings(Result<Value> read) {
  if (!read) return read.error();
  return ReadSketch{std::move(*read), {}};
}

std::string sentence(SvgWarning const& warning) {
  return "left out " + std::to_string(warning.count) + " with " + warning.reason +
         " (the first at byte " + std::to_string(warning.first_byte) + ")";
}

Result<ReadSketch> read_svg_sketch(std::span<std::byte const> content) {
  auto read = read_svg_with_warnings(content);
  if (!read) return read.error();
  ReadSketch sketch = {std::move(read->drawing.sketch), {}};
  for (auto const& warning : read->warnings) sketch.warnings.push_back(sentence(warning));
  return sketch;
}

}  // namespace

Result<ReadSketch> read_sketch(std::span<std::byte const> content) {
  switch (sniff_format(content)) {
    case FileFormat::Svg:
      return read_svg_sketch(content);
    case FileFormat::Scap:
      return without_warnings(read_scap(content));
    case FileFormat::Png:
    case FileFormat::Jpeg:
      return without_warnings(read_picture(content));
    case FileFormat::Zip:
      return Error{ErrorCode::Unsupported, "zip archives cannot be simplified"};
    case FileFormat::Unknown:
      break;
  }
  return Error{ErrorCode::Unsupported,
               "not a format we know; simplify reads SVG, SCAP, PNG and JPEG"};
}

}  // namespace inkflate::cli
