// SPDX-License-Identifier: Apache-2.0
#include "io/read_obj.h"

#include <array>
#include <optional>

#include "io/numbers.h"
#include "io/text_words.h"

namespace inkflate {
namespace {

class ObjReader {
 public:
  std::optional<Error> read_line(std::string_view line) {
    ++line_number_;
    auto const word = take_word(line);
    if (word == "v") return read_vertex(line);
    if (word == "f") return read_face(line);
    if (word == "vt") reading_.has_texture = true;
    if (word == "o") reading_.names.emplace_back(trimmed(line));
    return std::nullopt;
  }

  /// Faces may name vertices that come later, so their indices are looked at in the end.
  Result<MeshReading> finish() {
    auto const count = std::ssize(reading_.mesh.points);
    for (auto const& triangle : reading_.mesh.triangles) {
      for (int const corner : triangle) {
        if (corner < count) continue;
        return Error{ErrorCode::BadInput,
                     "OBJ: a face names vertex " + std::to_string(corner + 1) + " of " +
                         std::to_string(count),
                     corner + 1};
      }
    }
    return std::move(reading_);
  }

 private:
  Error fail(char const* what) const {
    return {ErrorCode::BadInput,
            std::string("OBJ: ") + what + " in line " + std::to_string(line_number_), line_number_};
  }

  std::optional<Error> read_vertex(std::string_view line) {
    std::array<double, 3> numbers = {};
    for (auto& number : numbers) {
      skip_separator(line, Separator::Blank);
      auto const taken = take_number(line);
      if (!taken) return fail("a vertex without three numbers");
      number = *taken;
    }
    if (std::ssize(reading_.mesh.points) == MeshLimits::kPoints) {
      return Error{ErrorCode::TooLarge, "the mesh has over 6 million vertices"};
    }
    reading_.mesh.points.push_back({numbers[0], numbers[1], numbers[2]});
    return std::nullopt;
  }

  /// A corner is "v", "v/vt", "v//vn" or "v/vt/vn"; negative ones count from the last vertex so far.
  std::optional<int> vertex_of(std::string_view corner) const {
    bool const is_backward = corner.substr(0, 1) == "-";
    if (is_backward) corner.remove_prefix(1);
    auto const number = take_index(corner);
    if (!number || *number == 0 || (!corner.empty() && corner.front() != '/')) return std::nullopt;
    auto const count = std::ssize(reading_.mesh.points);
    if (!is_backward) return *number - 1;
    if (*number > count) return std::nullopt;
    return static_cast<int>(count) - *number;
  }

  std::optional<Error> read_face(std::string_view line) {
    std::array<int, 2> fan = {};  // the first corner and the last one so far
    int corners = 0;
    for (auto corner = take_word(line); !corner.empty(); corner = take_word(line)) {
      auto const vertex = vertex_of(corner);
      if (!vertex) return fail("a corner that names no vertex");
      if (corners >= 2) {
        if (std::ssize(reading_.mesh.triangles) == MeshLimits::kTriangles) {
          return Error{ErrorCode::TooLarge, "the mesh has over 2 million triangles"};
        }
        reading_.mesh.triangles.push_back({fan[0], fan[1], *vertex});
      }
      fan[corners == 0 ? 0 : 1] = *vertex;
      ++corners;
    }
    if (corners < 3) return fail("a face with fewer than three corners");
    return std::nullopt;
  }

  MeshReading reading_;
  long long line_number_ = 0;
};

}  // namespace

Result<MeshReading> read_obj(std::span<std::byte const> file) {
  std::string_view text(reinterpret_cast<char const*>(file.data()), file.size());
  ObjReader reader;
  while (!text.empty()) {
    if (auto const error = reader.read_line(take_line(text))) return *error;
  }
  return reader.finish();
}

}  // namespace inkflate
