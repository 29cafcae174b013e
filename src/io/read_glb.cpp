// SPDX-License-Identifier: Apache-2.0
#include "io/read_glb.h"

#include <array>
#include <optional>

#include "io/float_bytes.h"
#include "io/json_look.h"
#include "io/parse_json.h"

namespace inkflate {
namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinaryChunk = 0x004e4942;
constexpr std::int64_t kByte = 5121;
constexpr std::int64_t kShort = 5123;
constexpr std::int64_t kInt = 5125;
constexpr std::int64_t kFloat = 5126;
constexpr std::int64_t kTriangleMode = 4;

Error damaged(std::string const& what, long long index = -1) {
  return {ErrorCode::BadInput, "GLB: " + what, index};
}
Error unsupported(std::string const& what) {
  return {ErrorCode::Unsupported, "GLB: " + what + " cannot be read"};
}

struct Glb {
  nlohmann::json json;
  std::span<std::byte const> binary;
};

Result<Glb> open_glb(std::span<std::byte const> file) {
  if (file.size() < kHeaderBytes + kChunkHeaderBytes) return damaged("the file is cut off");
  if (little_endian32(file.subspan(4)) != 2) return unsupported("another version than 2");
  if (little_endian32(file.subspan(8)) != file.size()) {
    return damaged("the file is not as long as it says");
  }
  Glb glb;
  bool has_json = false;
  for (auto rest = file.subspan(kHeaderBytes); !rest.empty();) {
    if (rest.size() < kChunkHeaderBytes) return damaged("a chunk is cut off");
    std::size_t const size = little_endian32(rest);
    auto const type = little_endian32(rest.subspan(4));
    rest = rest.subspan(kChunkHeaderBytes);
    if (size > rest.size()) return damaged("a chunk is cut off");
    if (!has_json) {
      if (type != kJsonChunk) return damaged("the first chunk is not JSON");
      std::string_view const text(reinterpret_cast<char const*>(rest.data()), size);
      auto json = parse_json(text);
      if (!json) return Error{json.error().code, "GLB: " + json.error().message};
      glb.json = std::move(*json);
      has_json = true;
    } else if (type == kBinaryChunk && glb.binary.empty()) {
      glb.binary = rest.first(size);
    }
    rest = rest.subspan(size);
  }
  return glb;
}

/// The elements of an accessor, proven to lie in the file.
struct Elements {
  std::span<std::byte const> bytes;  // from the first element on
  std::int64_t stride = 0;
  std::int64_t count = 0;
  std::int64_t component = 0;  // its type

  std::span<std::byte const> at(std::int64_t i) const {
    return bytes.subspan(static_cast<std::size_t>(i * stride));
  }
};

std::int64_t component_bytes(std::int64_t type) {
  return type == kByte ? 1 : type == kShort ? 2 : type == kInt || type == kFloat ? 4 : 0;
}

Result<Elements> elements_of(Glb const& glb, JsonPlace accessor, std::string_view type) {
  auto const component = whole_number(member(accessor, "componentType")).value_or(0);
  auto const count = whole_number(member(accessor, "count")).value_or(0);
  if (text_of(member(accessor, "type")) != type || component_bytes(component) == 0 || count == 0) {
    return damaged("an accessor is not what it is used for");
  }
  if (member(accessor, "sparse") != nullptr) return unsupported("a sparse accessor");
  auto const view_index = whole_number(member(accessor, "bufferView"));
  if (!view_index) return unsupported("an accessor without data");
  auto const* const view = element(member(&glb.json, "bufferViews"), *view_index);
  if (whole_number(member(view, "buffer")) != 0 ||
      member(element(member(&glb.json, "buffers"), 0), "uri") != nullptr) {
    return unsupported("data outside of the file");
  }
  auto const view_at = whole_number_or(member(view, "byteOffset"), 0);
  auto const view_bytes = whole_number(member(view, "byteLength"));
  auto const at = whole_number_or(member(accessor, "byteOffset"), 0);
  auto const element_bytes = component_bytes(component) * (type == "VEC3" ? 3 : 1);
  auto const stride = whole_number_or(member(view, "byteStride"), element_bytes);
  if (!view_at || !view_bytes || !at || !stride) return damaged("a view's numbers are none");
  // Each is at most 2^53; made small first, their products stay below 2^63.
  auto const size = std::ssize(glb.binary);
  bool const is_inside = *view_at <= size && *view_bytes <= size - *view_at && *at <= *view_bytes &&
                         count <= size && *stride >= element_bytes && *stride <= size &&
                         (count - 1) * *stride + element_bytes <= *view_bytes - *at;
  if (!is_inside) return damaged("an accessor reaches beyond its data");
  auto const first = static_cast<std::size_t>(*view_at + *at);
  return Elements{glb.binary.subspan(first, static_cast<std::size_t>(*view_bytes - *at)), *stride,
                  count, component};
}

std::int64_t index_at(Elements const& indices, std::int64_t i) {
  auto const bytes = indices.at(i);
  if (indices.component == kByte) return static_cast<std::int64_t>(bytes[0]);
  return indices.component == kShort ? little_endian16(bytes) : little_endian32(bytes);
}

std::optional<Error> add_triangles(MeshReading& reading, std::optional<Elements> const& indices,
                                   std::int64_t first_point, std::int64_t point_count) {
  std::int64_t const corners = indices ? indices->count : point_count;
  if (corners % 3 != 0) return damaged("the corners are no multiple of three");
  if (std::ssize(reading.mesh.triangles) + corners / 3 > MeshLimits::kTriangles) {
    return Error{ErrorCode::TooLarge, "the mesh has over 2 million triangles"};
  }
  for (std::int64_t i = 0; i < corners; i += 3) {
    Triangle triangle = {};
    for (std::int64_t c = 0; c < 3; ++c) {
      std::int64_t const index = indices ? index_at(*indices, i + c) : i + c;
      if (index >= point_count) {
        return damaged("index " + std::to_string(i + c) + " names no vertex", i + c);
      }
      triangle[static_cast<std::size_t>(c)] = static_cast<int>(first_point + index);
    }
    reading.mesh.triangles.push_back(triangle);
  }
  return std::nullopt;
}

std::optional<Error> add_primitive(MeshReading& reading, Glb const& glb, JsonPlace primitive) {
  if (whole_number_or(member(primitive, "mode"), kTriangleMode) != kTriangleMode) {
    return unsupported("a mesh of other things than triangles");
  }
  auto const* const accessors = member(&glb.json, "accessors");
  auto const position = whole_number(member(member(primitive, "attributes"), "POSITION"));
  if (!position) return damaged("a mesh has no positions");
  auto const points = elements_of(glb, element(accessors, *position), "VEC3");
  if (!points) return points.error();
  if (points->component != kFloat) return unsupported("packed positions");
  auto const first_point = std::ssize(reading.mesh.points);
  if (first_point + points->count > MeshLimits::kPoints) {
    return Error{ErrorCode::TooLarge, "the mesh has over 6 million vertices"};
  }
  for (std::int64_t i = 0; i < points->count; ++i) {
    auto const bytes = points->at(i);
    reading.mesh.points.push_back({little_endian_float32(bytes),
                                   little_endian_float32(bytes.subspan(4)),
                                   little_endian_float32(bytes.subspan(8))});
  }
  std::optional<Elements> indices;
  if (auto const* const place = member(primitive, "indices"); place != nullptr) {
    auto const read =
        elements_of(glb, element(accessors, whole_number(place).value_or(-1)), "SCALAR");
    if (!read) return read.error();
    if (read->component == kFloat) return damaged("indices are not whole numbers");
    indices = *read;
  }
  return add_triangles(reading, indices, first_point, points->count);
}

void add_names(MeshReading& reading, JsonPlace mesh) {
  auto const* const layers = member(member(mesh, "extras"), "layers");
  for (std::int64_t i = 0; i < count_of(layers); ++i) {
    if (auto const name = text_of(member(element(layers, i), "name"))) {
      reading.names.emplace_back(*name);
    }
  }
  if (count_of(layers) > 0) return;
  if (auto const name = text_of(member(mesh, "name"))) reading.names.emplace_back(*name);
}

std::optional<Error> add_mesh(MeshReading& reading, Glb const& glb, std::int64_t index) {
  auto const* const mesh = element(member(&glb.json, "meshes"), index);
  auto const* const primitives = member(mesh, "primitives");
  if (count_of(primitives) == 0) return damaged("a node shows a mesh that is not there");
  for (std::int64_t i = 0; i < count_of(primitives); ++i) {
    if (auto error = add_primitive(reading, glb, element(primitives, i))) return error;
  }
  return std::nullopt;
}

bool has_transform(JsonPlace node) {
  for (char const* const part : {"matrix", "translation", "rotation", "scale"}) {
    if (member(node, part) != nullptr) return true;
  }
  return false;
}

/// For each node whether it or one above it moves what it shows. A node above itself is found, too.
Result<std::vector<bool>> moved_nodes(JsonPlace nodes) {
  auto const count = count_of(nodes);
  std::vector<std::int64_t> parents(static_cast<std::size_t>(count), -1);
  for (std::int64_t i = 0; i < count; ++i) {
    auto const* const children = member(element(nodes, i), "children");
    for (std::int64_t c = 0; c < count_of(children); ++c) {
      auto const child = whole_number(element(children, c)).value_or(count);
      if (child >= count) return damaged("a node has a child that is not there", i);
      auto& parent = parents[static_cast<std::size_t>(child)];
      if (parent >= 0) return damaged("a node has two parents", child);
      parent = i;
    }
  }
  std::vector<bool> is_moved(static_cast<std::size_t>(count));
  std::vector<std::int64_t> ready;  // roots, then those whose parents were seen
  for (std::int64_t i = 0; i < count; ++i) {
    if (parents[static_cast<std::size_t>(i)] < 0) ready.push_back(i);
  }
  for (std::size_t next = 0; next < ready.size(); ++next) {
    auto const i = static_cast<std::size_t>(ready[next]);
    bool const is_above = parents[i] >= 0 && is_moved[static_cast<std::size_t>(parents[i])];
    is_moved[i] = is_above || has_transform(element(nodes, ready[next]));
    auto const* const children = member(element(nodes, ready[next]), "children");
    for (std::int64_t c = 0; c < count_of(children); ++c) {
      ready.push_back(*whole_number(element(children, c)));
    }
  }
  if (std::ssize(ready) != count) return damaged("nodes form a circle");
  return is_moved;
}

}  // namespace

Result<MeshReading> read_glb(std::span<std::byte const> file) {
  auto const glb = open_glb(file);
  if (!glb) return glb.error();
  auto const* const nodes = member(&glb->json, "nodes");
  auto const is_moved = moved_nodes(nodes);
  if (!is_moved) return is_moved.error();
  MeshReading reading;
  reading.has_texture = count_of(member(&glb->json, "textures")) > 0;
  auto const* const meshes = member(&glb->json, "meshes");
  for (std::int64_t i = 0; i < count_of(meshes); ++i) add_names(reading, element(meshes, i));
  for (std::int64_t i = 0; i < count_of(nodes); ++i) {
    auto const* const node = element(nodes, i);
    auto const* const mesh = member(node, "mesh");
    if (mesh == nullptr) continue;
    // A skin takes the place of the node's own motion (specification, section 3.7.3.3).
    bool const has_skin = member(node, "skin") != nullptr;
    if ((*is_moved)[static_cast<std::size_t>(i)] && !has_skin) {
      return unsupported("a mesh that its node moves");
    }
    if (auto const error = add_mesh(reading, *glb, whole_number(mesh).value_or(-1))) return *error;
  }
  return reading;
}

}  // namespace inkflate
