// SPDX-License-Identifier: Apache-2.0
#include "io/write_glb.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>

#include "base/check.h"
#include "io/file_vertices.h"
#include "io/model_units.h"
#include "io/put_bytes.h"
#include "io/write_png.h"
#include "mesh/check_mesh.h"

namespace inkflate {
namespace {

using Json = nlohmann::ordered_json;

// The specification's numbers (sections 5.1, 5.11 and 5.26).
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kVertexData = 34962;
constexpr int kIndexData = 34963;
constexpr int kLinear = 9729;
constexpr int kLinearBetweenMipmaps = 9987;
constexpr int kClampToEdge = 33071;

// 65 535 is no index: it restarts strips.
constexpr std::ptrdiff_t kMostShortVertices = 65'535;

// Of the light that comes back, as glTF wants it; on the screen this is the clay's (214, 141, 104).
constexpr std::array kClayColour = {0.67, 0.266, 0.138, 1.0};
constexpr double kRoughness = 0.8;

/// The binary part, and what the JSON says about it.
struct Store {
  std::vector<std::byte> bytes;
  Json views = Json::array();
  Json accessors = Json::array();
};

void pad(std::vector<std::byte>& bytes, std::byte filler) {
  while (bytes.size() % 4 != 0) bytes.push_back(filler);
}

/// Declares the bytes from `start` to the end as a view; target 0: none.
Json::size_type close_view(Store& store, std::size_t start, int target) {
  Json view = {{"buffer", 0}, {"byteOffset", start}, {"byteLength", store.bytes.size() - start}};
  if (target != 0) view["target"] = target;
  store.views.push_back(std::move(view));
  pad(store.bytes, std::byte{0});
  return store.views.size() - 1;
}

Json::size_type add_accessor(Store& store, Json accessor) {
  store.accessors.push_back(std::move(accessor));
  return store.accessors.size() - 1;
}

Json::size_type add_positions(Store& store, RestModel const& model, FileVertices const& vertices) {
  auto const start = store.bytes.size();
  std::array<float, 3> low = {};
  std::array<float, 3> high = {};
  for (std::size_t i = 0; i < vertices.sources.size(); ++i) {
    Vec3 const point =
        model.mesh.points[static_cast<std::size_t>(vertices.sources[i])] * kFileUnitsPerPx;
    std::array const stored = {static_cast<float>(point.x) + 0.0F,
                               static_cast<float>(point.y) + 0.0F,
                               static_cast<float>(point.z) + 0.0F};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = i == 0 ? stored[axis] : std::min(low[axis], stored[axis]);
      high[axis] = i == 0 ? stored[axis] : std::max(high[axis], stored[axis]);
      put_float32(store.bytes, stored[axis]);
    }
  }
  // Readers compare the bounds with what is stored: exactly, so as single precision made double.
  auto const json = [](std::array<float, 3> const& corner) {
    return Json::array({double{corner[0]}, double{corner[1]}, double{corner[2]}});
  };
  return add_accessor(store, {{"bufferView", close_view(store, start, kVertexData)},
                              {"componentType", kFloat},
                              {"count", vertices.sources.size()},
                              {"type", "VEC3"},
                              {"min", json(low)},
                              {"max", json(high)}});
}

Json::size_type add_normals(Store& store, RestModel const& model, FileVertices const& vertices) {
  auto const start = store.bytes.size();
  for (int const source : vertices.sources) {
    auto const& normal = model.normals[static_cast<std::size_t>(source)];
    for (double const part : {normal.x, normal.y, normal.z}) put_float32(store.bytes, part);
  }
  return add_accessor(store, {{"bufferView", close_view(store, start, kVertexData)},
                              {"componentType", kFloat},
                              {"count", vertices.sources.size()},
                              {"type", "VEC3"}});
}

Json::size_type add_uvs(Store& store, FileVertices const& vertices) {
  auto const start = store.bytes.size();
  for (auto const uv : vertices.uvs) {
    put_float32(store.bytes, uv.x);
    put_float32(store.bytes, uv.y);
  }
  return add_accessor(store, {{"bufferView", close_view(store, start, kVertexData)},
                              {"componentType", kFloat},
                              {"count", vertices.uvs.size()},
                              {"type", "VEC2"}});
}

Json::size_type add_indices(Store& store, FileVertices const& vertices) {
  auto const start = store.bytes.size();
  bool const is_short = std::ssize(vertices.sources) <= kMostShortVertices;
  for (auto const& triangle : vertices.triangles) {
    for (int const corner : triangle) {
      auto const index = static_cast<std::uint32_t>(corner);
      is_short ? put_little_endian16(store.bytes, index) : put_little_endian32(store.bytes, index);
    }
  }
  return add_accessor(store, {{"bufferView", close_view(store, start, kIndexData)},
                              {"componentType", is_short ? kUnsignedShort : kUnsignedInt},
                              {"count", vertices.triangles.size() * 3},
                              {"type", "SCALAR"}});
}

Json primitive_json(Store& store, RestModel const& model, FileVertices const& vertices) {
  Json attributes;
  attributes["POSITION"] = add_positions(store, model, vertices);
  attributes["NORMAL"] = add_normals(store, model, vertices);
  if (!vertices.uvs.empty()) attributes["TEXCOORD_0"] = add_uvs(store, vertices);
  Json primitive;
  primitive["attributes"] = std::move(attributes);
  primitive["indices"] = add_indices(store, vertices);
  primitive["material"] = 0;
  return primitive;
}

/// Which triangles are whose: one primitive has no other place for the layers' names.
Json layers_json(RestModel const& model) {
  Json layers = Json::array();
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    auto const layer = static_cast<std::size_t>(model.faces[i].layer);
    if (i == 0 || model.faces[i - 1].layer != model.faces[i].layer) {
      layers.push_back({{"name", layer < model.layer_names.size() ? model.layer_names[layer] : ""},
                        {"first_triangle", i},
                        {"triangles", 0}});
    }
    auto& count = layers.back()["triangles"];
    count = count.get<std::int64_t>() + 1;
  }
  return layers;
}

Json material_json(bool has_texture, bool is_closed) {
  Json surface;
  if (has_texture) surface["baseColorTexture"] = {{"index", 0}};
  if (!has_texture) surface["baseColorFactor"] = kClayColour;
  surface["metallicFactor"] = 0;
  surface["roughnessFactor"] = kRoughness;
  Json material = {{"name", has_texture ? "drawing" : "clay"}, {"pbrMetallicRoughness", surface}};
  // Through an open end the inside is seen.
  if (!is_closed) material["doubleSided"] = true;
  return material;
}

void add_texture(Json& root, Store& store, Texture const& texture) {
  auto const start = store.bytes.size();
  auto const png = write_png(texture.picture);
  store.bytes.insert(store.bytes.end(), png.begin(), png.end());
  root["textures"] = {{{"sampler", 0}, {"source", 0}}};
  root["images"] = {{{"name", "drawing"},
                     {"mimeType", "image/png"},
                     {"bufferView", close_view(store, start, 0)}}};
  root["samplers"] = {{{"magFilter", kLinear},
                       {"minFilter", kLinearBetweenMipmaps},
                       {"wrapS", kClampToEdge},
                       {"wrapT", kClampToEdge}}};
}

void put_chunk(std::vector<std::byte>& file, std::string_view type,
               std::span<std::byte const> data) {
  put_little_endian32(file, static_cast<std::uint32_t>(data.size()));
  put_text(file, type);
  file.insert(file.end(), data.begin(), data.end());
}

std::vector<std::byte> container(Json const& root, std::vector<std::byte> const& binary) {
  std::vector<std::byte> text;
  put_text(text, root.dump(-1, ' ', false, Json::error_handler_t::replace));
  pad(text, std::byte{' '});
  constexpr std::size_t header_bytes = 12;
  constexpr std::size_t chunk_header_bytes = 8;
  std::vector<std::byte> file;
  put_text(file, "glTF");
  put_little_endian32(file, 2);
  put_little_endian32(file, static_cast<std::uint32_t>(header_bytes + 2 * chunk_header_bytes +
                                                       text.size() + binary.size()));
  put_chunk(file, "JSON", text);
  put_chunk(file, std::string_view("BIN\0", 4), binary);
  return file;
}

}  // namespace

std::vector<std::byte> write_glb(RestModel const& model, Texture const* texture,
                                 std::string const& name) {
  CHECK(!model.mesh.triangles.empty(), "a GLB has at least one triangle");
  CHECK(model.normals.size() == model.mesh.points.size(), "each vertex has a normal");
  auto const vertices = file_vertices(model, texture);
  Store store;
  Json mesh;
  mesh["name"] = name;
  mesh["primitives"] = Json::array({primitive_json(store, model, vertices)});
  mesh["extras"] = {{"layers", layers_json(model)}};
  Json root;
  root["asset"] = {{"version", "2.0"}, {"generator", "Inkflate " INKFLATE_VERSION}};
  root["scene"] = 0;
  root["scenes"] = {{{"nodes", {0}}}};
  root["nodes"] = {{{"name", name}, {"mesh", 0}}};
  root["meshes"] = Json::array({std::move(mesh)});
  root["materials"] =
      Json::array({material_json(texture != nullptr, check_mesh(model.mesh).is_closed())});
  if (texture != nullptr) add_texture(root, store, *texture);
  root["accessors"] = std::move(store.accessors);
  root["bufferViews"] = std::move(store.views);
  root["buffers"] = {{{"byteLength", store.bytes.size()}}};
  return container(root, store.bytes);
}

}  // namespace inkflate
