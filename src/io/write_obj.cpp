// SPDX-License-Identifier: Apache-2.0
#include "io/write_obj.h"

#include <cmath>

#include "base/check.h"
#include "io/file_vertices.h"
#include "io/model_units.h"
#include "io/numbers.h"
#include "io/write_png.h"
#include "io/xml_text.h"

namespace inkflate {
namespace {

constexpr char const* kClayMaterial = "newmtl clay\nKd 0.84 0.553 0.408\nKs 0 0 0\nillum 1\n";
constexpr char const* kDrawingMaterial = "newmtl drawing\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd ";

/// Six decimals: finer than single precision for every model up to the size of a canvas.
void append_decimal(std::string& text, double number) {
  append_number(text, std::round(number * 1e6) / 1e6 + 0.0);
}

void append_line(std::string& text, char const* word, std::initializer_list<double> numbers) {
  text += word;
  for (double const number : numbers) {
    text += ' ';
    append_decimal(text, number);
  }
  text += '\n';
}

// A name ends with its line; whatever would end it early is replaced.
std::string one_line(std::string const& name) {
  std::string clean = clean_utf8(name);
  for (char& c : clean) {
    if (static_cast<unsigned char>(c) < ' ') c = '_';
  }
  return clean.empty() ? "unnamed" : clean;
}

void append_vertices(std::string& text, RestModel const& model, FileVertices const& vertices) {
  for (auto const point : model.mesh.points) {
    auto const p = point * kFileUnitsPerPx;
    append_line(text, "v", {p.x, p.y, p.z});
  }
  for (auto const uv : vertices.uvs) append_line(text, "vt", {uv.x, 1 - uv.y});
  for (auto const n : model.normals) append_line(text, "vn", {n.x, n.y, n.z});
}

void append_face(std::string& text, Triangle const& triangle, Triangle const* places) {
  text += 'f';
  for (std::size_t c = 0; c < 3; ++c) {
    auto const vertex = std::to_string(triangle[c] + 1);
    text += ' ';
    text += vertex;
    text += '/';
    if (places != nullptr) text += std::to_string((*places)[c] + 1);
    text += '/';
    text += vertex;
  }
  text += '\n';
}

void append_faces(std::string& text, RestModel const& model, FileVertices const& vertices) {
  for (std::size_t i = 0; i < model.mesh.triangles.size(); ++i) {
    auto const layer = static_cast<std::size_t>(model.faces[i].layer);
    if (i == 0 || model.faces[i - 1].layer != model.faces[i].layer) {
      text += "o " + one_line(model.layer_names[layer]) + '\n';
      text += vertices.uvs.empty() ? "usemtl clay\n" : "usemtl drawing\n";
    }
    append_face(text, model.mesh.triangles[i],
                vertices.uvs.empty() ? nullptr : &vertices.triangles[i]);
  }
}

}  // namespace

ObjFiles write_obj(RestModel const& model, Texture const* texture, std::string const& name) {
  CHECK(model.normals.size() == model.mesh.points.size(), "each vertex has a normal");
  CHECK(model.faces.size() == model.mesh.triangles.size(), "each triangle has a face");
  auto const vertices = file_vertices(model, texture);
  auto const file_name = one_line(name);
  std::string const head = "# Inkflate " INKFLATE_VERSION "\n";
  ObjFiles files;
  files.obj = head + "mtllib " + file_name + ".mtl\n";
  append_vertices(files.obj, model, vertices);
  append_faces(files.obj, model, vertices);
  files.mtl = head;
  files.mtl += texture != nullptr ? kDrawingMaterial + file_name + ".png\n" : kClayMaterial;
  if (texture != nullptr) files.png = write_png(texture->picture);
  return files;
}

}  // namespace inkflate
