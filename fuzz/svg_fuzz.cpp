// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "base/check.h"
#include "io/read_svg.h"
#include "io/write_svg.h"

// Any bytes end in a drawing or an error, and a drawing survives being written and read.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const drawing = inkflate::read_svg(std::as_bytes(std::span(data, size)));
  if (!drawing) return 0;
  std::string const text = inkflate::write_svg(*drawing);
  auto const again = inkflate::read_svg(std::as_bytes(std::span(text.data(), text.size())));
  CHECK(again.has_value(), "a written drawing reads");
  CHECK(*again == *drawing, "a written drawing reads as the same");
  return 0;
}
