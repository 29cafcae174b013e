// SPDX-License-Identifier: Apache-2.0
// contour_hash FILE...: prints, for each file, a hash of the exact bits of its strokes and of every contour that
// simplify makes of them.
// Equal lines from every compiler and from WebAssembly show that the result depends on the file alone.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/hash.h"
#include "cli/read_document.h"

namespace {

using namespace inkflate;

void add_count(Hash& hash, std::ptrdiff_t count) { hash.add(static_cast<std::int64_t>(count)); }

void add_point(Hash& hash, Vec2 point) {
  hash.add(point.x);
  hash.add(point.y);
}

void add_outline(Hash& hash, Outline const& outline) {
  add_count(hash, std::ssize(outline.pieces));
  for (auto const& piece : outline.pieces) {
    hash.add(static_cast<std::int64_t>(piece.kind));
    for (auto const point : piece.curve.control) add_point(hash, point);
  }
}

std::uint64_t hash_of(Drawing const& drawing) {
  Hash hash;
  for (auto const& stroke : drawing.sketch.strokes) {
    add_count(hash, std::ssize(stroke.samples));
    for (auto const& sample : stroke.samples) add_point(hash, sample.position);
  }
  add_count(hash, std::ssize(drawing.layers));
  for (auto const& layer : drawing.layers) {
    add_count(hash, std::ssize(layer.outlines));
    for (auto const& outline : layer.outlines) add_outline(hash, outline);
  }
  return hash.value();
}

Result<Drawing> simplify_file(char const* path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return Error{ErrorCode::FileSystem, "cannot read"};
  std::vector<char> const content{std::istreambuf_iterator<char>(stream), {}};
  auto const document = cli::read_document(std::as_bytes(std::span(content)));
  if (!document) return document.error();
  return run_simplify(cli::sketch_source(*document));
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
