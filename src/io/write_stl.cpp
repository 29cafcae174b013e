// SPDX-License-Identifier: Apache-2.0
#include "io/write_stl.h"

#include <array>
#include <string_view>

#include "io/put_bytes.h"

namespace inkflate {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;

// Does not begin with "solid", which would tell that the file is text.
constexpr std::string_view kHeader = "Inkflate " INKFLATE_VERSION ", millimetres, z up";

Vec3 as_stored(Vec3 point) {
  return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
}

void put_point(std::vector<std::byte>& file, Vec3 point) {
  put_float32(file, point.x);
  put_float32(file, point.y);
  put_float32(file, point.z);
}

}  // namespace

std::vector<std::byte> write_stl(TriMesh const& mesh) {
  std::vector<std::byte> file;
  file.reserve(kHeaderBytes + 4 + kTriangleBytes * mesh.triangles.size());
  put_text(file, kHeader);
  file.resize(kHeaderBytes, std::byte{' '});
  put_little_endian32(file, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (auto const& triangle : mesh.triangles) {
    std::array<Vec3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
      corners[c] = as_stored(mesh.points[static_cast<std::size_t>(triangle[c])]);
    }
    put_point(file, normalized(cross(corners[1] - corners[0], corners[2] - corners[0])));
    for (auto const corner : corners) put_point(file, corner);
    put_little_endian16(file, 0);
  }
  return file;
}

}  // namespace inkflate
