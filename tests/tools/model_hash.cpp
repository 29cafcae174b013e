// SPDX-License-Identifier: Apache-2.0
// model_hash FILE...: prints, for each file, a hash of the exact bits of its strokes and of every contour that simplify makes
// of them, taken together and group by group, and one of the model that the groups' layers become.
// Equal lines from every compiler and from WebAssembly show that the result depends on the file alone.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/hash.h"
#include "io/read_document.h"
#include "pipeline/run_inflate.h"
#include "pipeline/run_simplify.h"

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

std::uint64_t hash_of(RestModel const& model) {
  Hash hash;
  add_count(hash, std::ssize(model.mesh.points));
  for (auto const& points : {model.mesh.points, model.normals}) {
    for (auto const p : points) {
      add_point(hash, {p.x, p.y});
      hash.add(p.z);
    }
  }
  for (auto const& triangle : model.mesh.triangles) {
    for (int const v : triangle) hash.add(static_cast<std::int64_t>(v));
  }
  return hash.value();
}

/// What one file becomes.
struct Hashes {
  std::uint64_t together = 0;
  std::uint64_t groups = 0;
  std::uint64_t model = 0;
};

Result<Hashes> hash_file(char const* path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return Error{ErrorCode::FileSystem, "cannot read"};
  std::vector<char> const content{std::istreambuf_iterator<char>(stream), {}};
  auto const document = read_document(std::as_bytes(std::span(content)));
  if (!document) return document.error();
  SketchSource source = document->project.drawing.sketch;
  if (document->scan) source = *document->scan;
  auto const together = run_simplify(source);
  if (!together) return together.error();
  RunSimplifyOptions options;
  options.simplify.parts = Parts::Groups;
  auto const groups = run_simplify(source, options);
  if (!groups) return groups.error();
  auto const model = run_inflate(*groups);
  if (!model) return model.error();
  return Hashes{hash_of(*together), hash_of(*groups), hash_of(*model)};
}

void print(std::uint64_t hash) { std::printf("%016llx ", static_cast<unsigned long long>(hash)); }

}  // namespace

int main(int count, char** arguments) {
  bool is_done = count > 1;
  for (int i = 1; i < count; ++i) {
    auto const run = hash_file(arguments[i]);
    auto const name = std::filesystem::path(arguments[i]).filename().string();
    is_done = is_done && run.has_value();
    if (run) {
      for (auto const hash : {run->together, run->groups, run->model}) print(hash);
      std::printf("%s\n", name.c_str());
    } else {
      std::printf("%s: %s\n", name.c_str(), run.error().message.c_str());
    }
  }
  return is_done ? 0 : 1;
}
