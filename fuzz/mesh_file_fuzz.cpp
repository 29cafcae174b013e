// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "io/read_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const reading = inkflate::read_mesh(std::as_bytes(std::span(data, size)));
  if (!reading) return 0;
  auto const count = std::ssize(reading->mesh.points);
  for (auto const& triangle : reading->mesh.triangles) {
    for (int const corner : triangle) {
      if (corner < 0 || corner >= count) std::abort();
    }
  }
  return 0;
}
