// SPDX-License-Identifier: Apache-2.0
#include "io/write_document_json.h"

#include "io/clip_json.h"
#include "io/document_file.h"
#include "io/layer_json.h"
#include "io/stroke_json.h"

namespace inkflate {

using Json = nlohmann::ordered_json;

// What documents have had from the beginning is always written, newer members only where they say something: so a document that
// needs none of them stays the same to the last byte.
Json document_json(Project const& project, std::string_view template_name) {
  auto const& drawing = project.drawing;
  Json json;
  json["format"] = kDocumentFormat;
  json["version"] = kDocumentVersion;
  json["canvas"]["width"] = drawing.sketch.width_px;
  json["canvas"]["height"] = drawing.sketch.height_px;
  if (!template_name.empty()) json["template"] = template_name;
  json["groups"] = json["strokes"] = json["layers"] = Json::array();
  for (auto const& group : drawing.sketch.groups) json["groups"].push_back(group_json(group));
  for (auto const& stroke : drawing.sketch.strokes) json["strokes"].push_back(stroke_json(stroke));
  for (auto const& layer : drawing.layers) json["layers"].push_back(layer_json(layer));
  json["stray"] = drawing.stray;
  if (drawing.choice != CloseChoice{}) json["choice"] = choice_json(drawing.choice);
  for (auto const& pin : project.pins) json["pins"].push_back(pin_json(pin));
  if (project.clip != Clip{}) json["clip"] = clip_json(project.clip);
  if (project.next_id != 1) json["next_id"] = project.next_id;
  return json;
}

std::string json_text(Json const& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string write_document_json(Project const& project, std::string_view template_name) {
  return json_text(document_json(project, template_name));
}

}  // namespace inkflate
