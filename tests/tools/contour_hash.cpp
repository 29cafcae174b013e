// SPDX-License-Identifier: Apache-2.0
// contour_hash FILE...: prints, for each file, a hash of the exact bits of every contour that simplify makes of it.
// Equal lines from every compiler and from WebAssembly show that the result depends on the file alone.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/hash.h"
#include "cli/read_sketch.h"

namespace {

using namespace inkflate;

std::uint64_t hash_of(Drawing const& drawing) {
  Hash hash;
  for (auto const& layer : drawing.layers) {
    hash.add(std::ssize(layer.outlines));
    for (auto const& outline : layer.outlines) {
      hash.add(std::ssize(outline.pieces));
      for (auto const& piece : outline.pieces) {
        hash.add(static_cast<std::int64_t>(piece.kind));
        for (auto const point : piece.curve.control) {
          hash.add(point.x);
          hash.add(point.y);
        }
      }
    }
  }
  return hash.value();
}

Result<Drawing> simplify_file(char const* path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return Error{ErrorCode::FileSystem, "cannot read"};
  std::vector<char> const content{std::istreambuf_iterator<char>(stream), {}};
  auto const sketch = cli::read_sketch(std::as_bytes(std::span(content)));
  if (!sketch) return sketch.error();
  return run_simplify(sketch->source);
}

}  // namespace

int main(int count, char** arguments) {
  bool is_done = count > 1;
  for (int i = 1; i < count; ++i) {
    auto const run = simplify_file(arguments[i]);
    auto const name = std::filesystem::path(arguments[i]).filename().string();
    is_done = is_done && run.has_value();
    if (run) {
      std::printf("%016llx %s\n", static_cast<unsigned long long>(hash_of(*run)), name.c_str());
    } else {
      std::printf("%s: %s\n", name.c_str(), run.error().message.c_str());
    }
  }
  return is_done ? 0 : 1;
}
