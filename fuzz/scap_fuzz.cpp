// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>

#include "base/check.h"
#include "io/read_scap.h"

// Any bytes end in an error or in a sketch whose numbers are in range.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const sketch = inkflate::read_scap(std::as_bytes(std::span(data, size)));
  if (!sketch) return 0;
  CHECK(sketch->width_px > 0 && sketch->height_px > 0, "the canvas has a size");
  for (auto const& stroke : sketch->strokes) {
    CHECK(!stroke.samples.empty() && stroke.width_px >= 0, "a stroke is something");
    for (auto const& sample : stroke.samples) {
      auto const p = sample.position;
      CHECK(std::abs(p.x) <= 1e6 && std::abs(p.y) <= 1e6, "samples are in range");
      CHECK(sample.pressure >= 0 && sample.pressure <= 1, "pressure is in range");
    }
  }
  return 0;
}
