// SPDX-License-Identifier: Apache-2.0
#include "io/write_document_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/svg_colour.h"

namespace inkflate {
namespace {

using Json = nlohmann::ordered_json;

// One number for each sample; left out where all are what the reader takes without them.
void put_per_sample(Json& json, char const* name, std::vector<Sample> const& samples,
                    double Sample::*member, double usual) {
  bool const is_usual = std::all_of(samples.begin(), samples.end(),
                                    [&](Sample const& sample) { return sample.*member == usual; });
  if (is_usual) return;
  Json numbers = Json::array();
  for (auto const& sample : samples) numbers.push_back(sample.*member);
  json[name] = std::move(numbers);
}

Json stroke_json(Stroke const& stroke) {
  Json positions = Json::array();
  for (auto const& sample : stroke.samples) {
    positions.push_back(sample.position.x);
    positions.push_back(sample.position.y);
  }
  Json json;
  json["kind"] = word(stroke.kind);
  json["width"] = stroke.width_px;
  json["colour"] = colour_hex(stroke.colour);
  if (stroke.group >= 0) json["group"] = stroke.group;
  json["positions"] = std::move(positions);
  put_per_sample(json, "pressures", stroke.samples, &Sample::pressure, 1);
  put_per_sample(json, "times", stroke.samples, &Sample::time_s, 0);
  return json;
}

Json kinds_json(std::vector<OutlinePiece> const& pieces) {
  Json kinds = Json::array();
  for (std::size_t i = 0, next = 0; i < pieces.size(); i = next) {
    while (next < pieces.size() && pieces[next].kind == pieces[i].kind) ++next;
    kinds.push_back(Json::array({word(pieces[i].kind), next - i}));
  }
  return kinds;
}

Json outline_json(Outline const& outline) {
  Json points = Json::array();
  auto const put = [&](Vec2 p) {
    points.push_back(p.x);
    points.push_back(p.y);
  };
  if (!outline.pieces.empty()) put(outline.pieces[0].curve.start());
  for (auto const& piece : outline.pieces) {
    for (std::size_t i = 1; i < 4; ++i) put(piece.curve.control[i]);
  }
  Json sources = Json::array();
  for (auto const& source : outline.sources) {
    sources.push_back(
        Json::array({source.from, source.to, source.stroke, source.sample_from, source.sample_to}));
  }
  Json json;
  json["points"] = std::move(points);
  json["kinds"] = kinds_json(outline.pieces);
  json["sources"] = std::move(sources);
  return json;
}

// What groups and layers have in common.
Json look_json(std::string const& name, std::optional<Colour> const& fill, double thickness) {
  Json json;
  json["name"] = name;
  if (fill) json["fill"] = colour_hex(*fill);
  json["thickness"] = thickness;
  return json;
}

Json layer_json(Layer const& layer) {
  Json outlines = Json::array();
  for (auto const& outline : layer.outlines) outlines.push_back(outline_json(outline));
  Json json = look_json(layer.name, layer.fill, layer.thickness);
  json["outlines"] = std::move(outlines);
  json["strokes"] = layer.strokes;
  json["details"] = layer.details;
  return json;
}

}  // namespace

std::string write_document_json(DocumentFile const& document) {
  auto const& sketch = document.drawing.sketch;
  Json json;
  json["format"] = kDocumentFormat;
  json["version"] = kDocumentVersion;
  json["canvas"]["width"] = sketch.width_px;
  json["canvas"]["height"] = sketch.height_px;
  if (!document.template_name.empty()) json["template"] = document.template_name;
  json["groups"] = json["strokes"] = json["layers"] = Json::array();
  for (auto const& group : sketch.groups) {
    json["groups"].push_back(look_json(group.name, group.fill, group.thickness));
  }
  for (auto const& stroke : sketch.strokes) json["strokes"].push_back(stroke_json(stroke));
  for (auto const& layer : document.drawing.layers) json["layers"].push_back(layer_json(layer));
  json["stray"] = document.drawing.stray;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace inkflate
