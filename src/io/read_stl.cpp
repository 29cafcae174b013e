// SPDX-License-Identifier: Apache-2.0
#include "io/read_stl.h"

#include <array>

#include "io/float_bytes.h"
#include "io/numbers.h"
#include "io/text_words.h"

namespace inkflate {
namespace {

constexpr std::size_t kCountAt = 80;
constexpr std::size_t kTrianglesAt = 84;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kNormalBytes = 12;
constexpr std::size_t kPointBytes = 12;

void add_triangle(TriMesh& mesh, std::array<Vec3, 3> const& corners) {
  int const first = static_cast<int>(std::ssize(mesh.points));
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

std::optional<Vec3> take_point(std::string_view& text) {
  std::array<double, 3> numbers = {};
  for (auto& number : numbers) {
    skip_separator(text, Separator::Blank);
    auto const taken = take_number(text);
    if (!taken) return std::nullopt;
    number = *taken;
  }
  return Vec3{numbers[0], numbers[1], numbers[2]};
}

bool is_binary_stl(std::span<std::byte const> file) {
  if (file.size() < kTrianglesAt) return false;
  std::uint64_t const count = little_endian32(file.subspan(kCountAt));
  return file.size() == kTrianglesAt + kTriangleBytes * count;
}

Result<MeshReading> read_binary_stl(std::span<std::byte const> file) {
  MeshReading reading;
  auto const count = (file.size() - kTrianglesAt) / kTriangleBytes;
  static_assert(MeshLimits::kTriangles * 50 > (64LL << 20U),
                "no file is long enough to be over it");
  for (std::size_t i = 0; i < count; ++i) {
    std::array<Vec3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
      auto const bytes =
          file.subspan(kTrianglesAt + i * kTriangleBytes + kNormalBytes + c * kPointBytes);
      corners[c] = {little_endian_float32(bytes), little_endian_float32(bytes.subspan(4)),
                    little_endian_float32(bytes.subspan(8))};
    }
    add_triangle(reading.mesh, corners);
  }
  return reading;
}

Result<MeshReading> read_text_stl(std::string_view text) {
  auto const file = text;
  auto const fail = [&](char const* what) {
    long long const at = std::ssize(file) - std::ssize(text);
    return Error{ErrorCode::BadInput,
                 std::string("STL: ") + what + " before byte " + std::to_string(at), at};
  };
  MeshReading reading;
  std::array<Vec3, 3> corners;
  std::size_t corner_count = 0;
  bool has_ended = false;
  for (auto word = take_word(text); !word.empty(); word = take_word(text)) {
    if (word == "solid" || word == "endsolid") {
      has_ended = word == "endsolid";
      auto const name = trimmed(take_line(text));
      if (word == "solid" && !name.empty()) reading.names.emplace_back(name);
    } else if (word == "vertex") {
      auto const point = take_point(text);
      if (!point || corner_count == 3) return fail("a vertex that cannot be read");
      corners[corner_count++] = *point;
    } else if (word == "endloop") {
      if (corner_count != 3) return fail("a facet without three vertices");
      if (std::ssize(reading.mesh.triangles) == MeshLimits::kTriangles) {
        return Error{ErrorCode::TooLarge, "the mesh has over 2 million triangles"};
      }
      add_triangle(reading.mesh, corners);
      corner_count = 0;
    }
  }
  return has_ended && corner_count == 0 ? Result<MeshReading>(reading) : fail("the end is missing");
}

}  // namespace

Result<MeshReading> read_stl(std::span<std::byte const> file) {
  if (is_binary_stl(file)) return read_binary_stl(file);
  return read_text_stl({reinterpret_cast<char const*>(file.data()), file.size()});
}

}  // namespace inkflate
