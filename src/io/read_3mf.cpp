// SPDX-License-Identifier: Apache-2.0
#include "io/read_3mf.h"

#include <array>
#include <map>
#include <optional>
#include <string_view>

#include "io/numbers.h"
#include "io/read_zip.h"
#include "io/xml.h"
#include "io/xml_text.h"

namespace inkflate {
namespace {

// Enough for as many triangles as we take, each as long as 100 letters.
constexpr long long kMostModelBytes = 256LL << 20U;
// Objects shown, each time one is.
constexpr int kMostPlaced = 100'000;
constexpr XmlLimits kXmlLimits = {.max_bytes = kMostModelBytes,
                                  .max_elements = 10'000'000,
                                  .max_depth = 64,
                                  .max_attributes = 64};

Error damaged(std::string const& what, XmlReader const& xml) {
  auto const at = static_cast<long long>(xml.offset());
  return {ErrorCode::BadInput, "3MF: " + what + " at byte " + std::to_string(at) + " of the model",
          at};
}

/// Rows of a 4 x 3 matrix; a point is a row in front of it (core specification, section 3.3).
using Transform = std::array<double, 12>;
constexpr Transform kStay = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

Vec3 moved(Vec3 p, Transform const& m) {
  return {p.x * m[0] + p.y * m[3] + p.z * m[6] + m[9], p.x * m[1] + p.y * m[4] + p.z * m[7] + m[10],
          p.x * m[2] + p.y * m[5] + p.z * m[8] + m[11]};
}

/// An object that is to be shown, and where.
struct Placed {
  int object = -1;
  Transform transform = kStay;
};

struct Object {
  std::string name;
  TriMesh mesh;
  std::vector<Placed> components;
};

struct Package {
  std::map<int, Object> objects;
  std::vector<Placed> items;
  bool has_texture = false;
};

/// The name without the prefix of its namespace.
std::string_view local_name(std::string_view name) {
  auto const colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::optional<std::string_view> attribute(XmlTag const& tag, std::string_view name) {
  for (auto const& each : tag.attributes) {
    if (each.name == name) return trimmed(each.value);
  }
  return std::nullopt;
}

std::optional<int> index_attribute(XmlTag const& tag, std::string_view name) {
  auto text = attribute(tag, name);
  if (!text) return std::nullopt;
  auto const index = take_index(*text);
  return text->empty() ? index : std::nullopt;
}

std::optional<double> number_attribute(XmlTag const& tag, std::string_view name) {
  auto text = attribute(tag, name);
  if (!text) return std::nullopt;
  auto const number = take_number(*text);
  return text->empty() ? number : std::nullopt;
}

std::optional<Placed> placed_object(XmlTag const& tag) {
  auto const object = index_attribute(tag, "objectid");
  if (!object) return std::nullopt;
  Placed placed = {*object, kStay};
  if (auto text = attribute(tag, "transform")) {
    for (auto& number : placed.transform) {
      skip_separator(*text, Separator::Blank);
      auto const taken = take_number(*text);
      if (!taken) return std::nullopt;
      number = *taken;
    }
  }
  return placed;
}

class ModelReader {
 public:
  /// One start tag.
  std::optional<Error> read(XmlReader const& xml) {
    auto const& tag = xml.tag();
    auto const name = local_name(tag.name);
    if (name == "vertex") return read_vertex(xml);
    if (name == "triangle") return read_triangle(xml);
    if (name == "object") {
      auto const id = index_attribute(tag, "id");
      if (!id || package_.objects.count(*id) > 0)
        return damaged("an object without its own id", xml);
      object_ = &package_.objects[*id];
      if (auto const text = attribute(tag, "name")) object_->name = decode_xml(*text);
    }
    if (name == "component" || name == "item") {
      auto const placed = placed_object(tag);
      if (!placed || (name == "component" && object_ == nullptr)) {
        return damaged("a " + std::string(name) + " that cannot be read", xml);
      }
      (name == "item" ? package_.items : object_->components).push_back(*placed);
    }
    if (name == "texture2d") package_.has_texture = true;
    return std::nullopt;
  }

  Package take() { return std::move(package_); }

 private:
  std::optional<Error> read_vertex(XmlReader const& xml) {
    auto const x = number_attribute(xml.tag(), "x");
    auto const y = number_attribute(xml.tag(), "y");
    auto const z = number_attribute(xml.tag(), "z");
    if (!x || !y || !z || object_ == nullptr) return damaged("a vertex that cannot be read", xml);
    if (++points_ > MeshLimits::kPoints) {
      return Error{ErrorCode::TooLarge, "the mesh has over 6 million vertices"};
    }
    object_->mesh.points.push_back({*x, *y, *z});
    return std::nullopt;
  }

  std::optional<Error> read_triangle(XmlReader const& xml) {
    auto const a = index_attribute(xml.tag(), "v1");
    auto const b = index_attribute(xml.tag(), "v2");
    auto const c = index_attribute(xml.tag(), "v3");
    if (!a || !b || !c || object_ == nullptr) return damaged("a triangle that cannot be read", xml);
    // All vertices of a mesh stand before its triangles.
    auto const count = std::ssize(object_->mesh.points);
    if (*a >= count || *b >= count || *c >= count) {
      return damaged("a triangle that names no vertex", xml);
    }
    if (++triangles_ > MeshLimits::kTriangles) {
      return Error{ErrorCode::TooLarge, "the mesh has over 2 million triangles"};
    }
    object_->mesh.triangles.push_back({*a, *b, *c});
    return std::nullopt;
  }

  Package package_;
  Object* object_ = nullptr;  // that is being read; a map's values stay where they are
  long long points_ = 0;
  long long triangles_ = 0;
};

Result<Package> read_model(std::string_view text) {
  auto xml = XmlReader::open(text, kXmlLimits);
  if (!xml) return xml.error();
  ModelReader reader;
  for (;;) {
    auto const event = xml->next();
    if (!event) return event.error();
    if (*event == XmlEvent::End) return reader.take();
    if (*event != XmlEvent::Open) continue;
    if (auto const error = reader.read(*xml)) return *error;
  }
}

/// What is shown, put together.
class Scene {
 public:
  explicit Scene(Package const& package) : package_(package) {
    reading_.has_texture = package.has_texture;
  }

  std::optional<Error> add_item(Placed const& item) {
    auto const found = package_.objects.find(item.object);
    if (found == package_.objects.end()) return missing();
    if (auto error = add(found->second, {item.transform})) return error;
    for (auto const& component : found->second.components) {
      auto const part = package_.objects.find(component.object);
      if (part == package_.objects.end()) return missing();
      if (!part->second.components.empty()) {
        return Error{ErrorCode::Unsupported, "3MF: components of components cannot be read"};
      }
      if (auto error = add(part->second, {component.transform, item.transform})) return error;
    }
    return std::nullopt;
  }

  MeshReading take() { return std::move(reading_); }

 private:
  static Error missing() {
    return {ErrorCode::BadInput, "3MF: an object is shown that is not there"};
  }

  std::optional<Error> add(Object const& object, std::initializer_list<Transform> transforms) {
    if (++placed_ > kMostPlaced) {
      return Error{ErrorCode::TooLarge, "3MF: more than 100000 objects are shown"};
    }
    if (object.mesh.triangles.empty()) return std::nullopt;
    auto& mesh = reading_.mesh;
    if (std::ssize(mesh.points) + std::ssize(object.mesh.points) > MeshLimits::kPoints ||
        std::ssize(mesh.triangles) + std::ssize(object.mesh.triangles) > MeshLimits::kTriangles) {
      return Error{ErrorCode::TooLarge, "the mesh has over 2 million triangles"};
    }
    int const first = static_cast<int>(std::ssize(mesh.points));
    for (auto point : object.mesh.points) {
      for (auto const& transform : transforms) point = moved(point, transform);
      mesh.points.push_back(point);
    }
    for (auto const& t : object.mesh.triangles) {
      mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    if (!object.name.empty()) reading_.names.push_back(object.name);
    return std::nullopt;
  }

  Package const& package_;
  MeshReading reading_;
  int placed_ = 0;
};

/// The package's model: where everybody has it, in whatever case.
ZipEntry const* find_model(std::span<ZipEntry const> entries) {
  for (auto const& entry : entries) {
    if (lower_ascii(std::string_view(entry.name)) == "3d/3dmodel.model") return &entry;
  }
  return nullptr;
}

}  // namespace

Result<MeshReading> read_3mf(std::span<std::byte const> file) {
  auto const entries = read_zip_directory(file);
  if (!entries) return entries.error();
  auto const* const model = find_model(*entries);
  if (model == nullptr) return Error{ErrorCode::Unsupported, "3MF: there is no model inside"};
  if (model->size > kMostModelBytes) {
    return Error{ErrorCode::TooLarge, "3MF: the model is over 256 MB unpacked"};
  }
  auto const content = unpack(*model);
  if (!content) return content.error();
  std::string_view const text(reinterpret_cast<char const*>(content->data()), content->size());
  auto const package = read_model(text);
  if (!package) return package.error();
  Scene scene(*package);
  for (auto const& item : package->items) {
    if (auto const error = scene.add_item(item)) return *error;
  }
  return scene.take();
}

}  // namespace inkflate
