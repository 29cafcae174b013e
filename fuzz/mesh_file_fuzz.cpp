// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "io/read_mesh.h"
#include "io/write_zip.h"
#include "mesh/check_mesh.h"

namespace {

void read_and_check(std::span<std::byte const> file) {
  auto const reading = inkflate::read_mesh(file);
  if (!reading) return;
  auto const count = std::ssize(reading->mesh.points);
  for (auto const& triangle : reading->mesh.triangles) {
    for (int const corner : triangle) {
      if (corner < 0 || corner >= count) std::abort();
    }
  }
  // Larger ones take the same way, only longer.
  if (std::ssize(reading->mesh.triangles) > 2000) return;
  auto const welded = inkflate::weld_vertices(reading->mesh);
  static_cast<void>(inkflate::check_mesh(welded).is_sound());
  static_cast<void>(inkflate::count_self_crossings(welded, 100));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const input = std::as_bytes(std::span(data, size));
  read_and_check(input);
  // An archive with a wrong checksum is refused at once; with a right one, the model in it gets read.
  if (size > 0 && data[0] == '<') {
    std::vector const files = {inkflate::ZipFile{"3D/3dmodel.model", {input.begin(), input.end()}}};
    read_and_check(inkflate::write_zip(files));
  }
  return 0;
}
