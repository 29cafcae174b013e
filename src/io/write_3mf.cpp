// SPDX-License-Identifier: Apache-2.0
#include "io/write_3mf.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "base/check.h"
#include "io/numbers.h"
#include "io/put_bytes.h"
#include "io/write_zip.h"
#include "io/xml_text.h"

namespace inkflate {
namespace {

constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";
constexpr std::string_view kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";
constexpr std::string_view kModelHead =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Inkflate )" INKFLATE_VERSION R"(</metadata>
<resources>
)";

// The colours come first, then the objects, then the one that holds them all.
constexpr int kColoursId = 1;
constexpr int kFirstObjectId = 2;

std::string attribute(char const* name, std::string const& value) {
  return std::string(" ") + name + "=\"" + escape_xml(value) + '"';
}
std::string attribute(char const* name, int value) {
  return attribute(name, std::to_string(value));
}

void append_coordinate(std::string& text, char const* name, double number) {
  text += name;
  append_number(text, std::round(number * 1e6) / 1e6 + 0.0);
  text += '"';
}

void append_colours(std::string& text, std::span<PrintColour const> colours) {
  if (colours.empty()) return;
  text += "<basematerials" + attribute("id", kColoursId) + ">\n";
  for (auto const& each : colours) {
    std::array<char, 10> hex = {};
    auto const& c = each.colour;
    std::snprintf(hex.data(), hex.size(), "#%02X%02X%02X%02X", c.r, c.g, c.b, c.a);
    text += "<base" + attribute("name", each.name) + attribute("displaycolor", hex.data()) + "/>\n";
  }
  text += "</basematerials>\n";
}

void append_mesh(std::string& text, PrintObject const& object) {
  text += "<mesh><vertices>\n";
  for (auto const p : object.mesh.points) {
    text += "<vertex";
    append_coordinate(text, " x=\"", p.x);
    append_coordinate(text, " y=\"", p.y);
    append_coordinate(text, " z=\"", p.z);
    text += "/>\n";
  }
  text += "</vertices><triangles>\n";
  for (std::size_t i = 0; i < object.mesh.triangles.size(); ++i) {
    auto const& t = object.mesh.triangles[i];
    text += "<triangle v1=\"" + std::to_string(t[0]) + "\" v2=\"" + std::to_string(t[1]) +
            "\" v3=\"" + std::to_string(t[2]) + '"';
    // The object's own colour is that of its first triangle.
    if (!object.colours.empty() && object.colours[i] != object.colours[0]) {
      text += attribute("pid", kColoursId) + attribute("p1", object.colours[i]);
    }
    text += "/>\n";
  }
  text += "</triangles></mesh>";
}

void append_object(std::string& text, PrintObject const& object, int id) {
  text +=
      "<object" + attribute("id", id) + attribute("type", "model") + attribute("name", object.name);
  if (!object.colours.empty()) {
    text += attribute("pid", kColoursId) + attribute("pindex", object.colours[0]);
  }
  text += '>';
  append_mesh(text, object);
  text += "</object>\n";
}

std::string model_text(std::span<PrintObject const> objects, std::span<PrintColour const> colours,
                       std::string const& name) {
  std::string text(kModelHead);
  append_colours(text, colours);
  int id = kFirstObjectId;
  for (auto const& object : objects) append_object(text, object, id++);
  text += "<object" + attribute("id", id) + attribute("type", "model") + attribute("name", name) +
          "><components>";
  for (int part = kFirstObjectId; part < id; ++part) {
    text += "<component" + attribute("objectid", part) + "/>";
  }
  text += "</components></object>\n</resources>\n<build><item" + attribute("objectid", id) +
          "/></build>\n</model>\n";
  return text;
}

ZipFile zip_file(std::string const& name, std::string_view text) {
  ZipFile file = {name, {}};
  put_text(file.content, text);
  return file;
}

}  // namespace

std::vector<std::byte> write_3mf(std::span<PrintObject const> objects,
                                 std::span<PrintColour const> colours, std::string const& name) {
  CHECK(!objects.empty(), "a 3MF holds at least one object");
  for (auto const& object : objects) {
    CHECK(object.colours.empty() || object.colours.size() == object.mesh.triangles.size(),
          "every triangle has a colour, or none has");
  }
  std::array const files = {zip_file("[Content_Types].xml", kContentTypes),
                            zip_file("_rels/.rels", kRelationships),
                            zip_file("3D/3dmodel.model", model_text(objects, colours, name))};
  return write_zip(files);
}

}  // namespace inkflate
