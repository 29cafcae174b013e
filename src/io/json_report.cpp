// SPDX-License-Identifier: Apache-2.0
#include "io/json_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/polyline.h"

namespace inkflate {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kTolerancePx = 0.1;

double rounded(double number) { return std::round(number * 1000) / 1000; }

Json point_json(Vec2 point) { return Json::array({rounded(point.x), rounded(point.y)}); }

Json point_json(Vec3 point) {
  return Json::array({rounded(point.x), rounded(point.y), rounded(point.z)});
}

// The sign of the area does not tell a hole where an outline crosses itself.
Json contour_json(Outline const& outline, bool is_hole) {
  auto const contour = flatten(outline, kTolerancePx);
  Json points = Json::array();
  for (auto const point : contour) points.push_back(point_json(point));
  Json json;
  json["hole"] = is_hole;
  json["closed"] = true;
  json["area"] = rounded(std::abs(signed_area(contour)));
  json["perimeter"] = rounded(perimeter(contour));
  json["points"] = std::move(points);
  return json;
}

Json layer_json(Layer const& layer) {
  Json contours = Json::array();
  for (auto const& outline : layer.outlines) {
    contours.push_back(contour_json(outline, !contours.empty()));
  }
  Json json;
  json["name"] = layer.name;
  json["strokes"] = layer.strokes.size();
  json["details"] = layer.details.size();
  json["contours"] = std::move(contours);
  return json;
}

Json runs_json(std::vector<Layer> const& layers, RunKind kind) {
  Json list = Json::array();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    for (auto const& outline : layers[i].outlines) {
      for (auto const& run : runs(outline, kTolerancePx)) {
        if (run.kind != kind) continue;
        Json json;
        json["layer"] = i;
        json["from"] = point_json(run.points.front());
        json["to"] = point_json(run.points.back());
        json["length"] = rounded(length(run.points));
        list.push_back(std::move(json));
      }
    }
  }
  return list;
}

Json times_json(std::span<StageTime const> stages) {
  Json json = Json::object();
  double total = 0;
  for (auto const& [stage, ms] : stages) {
    json[stage] = rounded(ms);
    if (stage != "read" && stage != "write") total += ms;
  }
  json["total"] = rounded(total);
  return json;
}

// Text that is not UTF-8 must not stop a report.
std::string text_of(Json const& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string json_report(Drawing const& drawing, std::span<StageTime const> stages) {
  auto const& sketch = drawing.sketch;
  std::size_t samples = 0;
  for (auto const& stroke : sketch.strokes) samples += stroke.samples.size();
  Json layers = Json::array();
  for (auto const& layer : drawing.layers) layers.push_back(layer_json(layer));
  Json json;
  json["canvas"]["width"] = sketch.width_px;
  json["canvas"]["height"] = sketch.height_px;
  json["strokes"] = sketch.strokes.size();
  json["samples"] = samples;
  json["layers"] = std::move(layers);
  json["closings"] = runs_json(drawing.layers, RunKind::Closing);
  json["open"] = runs_json(drawing.layers, RunKind::HelpLine);
  json["stray"] = drawing.stray.size();
  json["ms"] = times_json(stages);
  return text_of(json);
}

std::string json_report(TriMesh const& mesh, MeshCheck const& check, ModelFacts const& facts,
                        std::span<StageTime const> stages) {
  Json json;
  json["vertices"] = mesh.points.size();
  json["triangles"] = mesh.triangles.size();
  json["layers"] = facts.layers;
  json["shells"] = check.shells;
  json["genus"] = check.genus;
  json["unit"] = facts.unit;
  json["volume"] = rounded(check.volume);
  json["bounding_box"]["min"] = point_json(check.min);
  json["bounding_box"]["max"] = point_json(check.max);
  json["ok"] = check.is_sound();
  json["ms"] = times_json(stages);
  return text_of(json);
}

std::string json_report(BendFacts const& facts, std::span<StageTime const> stages) {
  Json pins = Json::array();
  for (auto const& pin : facts.pins) {
    Json json;
    json["part"] = pin.part;
    json["from"] = point_json(pin.from);
    json["to"] = point_json(pin.to);
    json["ended"] = point_json(pin.ended);
    json["off"] = rounded(distance(pin.ended, pin.to));
    pins.push_back(std::move(json));
  }
  Json json;
  json["parts"] = facts.parts;
  json["pins"] = std::move(pins);
  json["steps"] = facts.steps;
  json["settled"] = facts.is_settled;
  json["ms"] = times_json(stages);
  return text_of(json);
}

std::string json_error(Error const& error) {
  Json json;
  json["error"]["code"] = error_code_name(error.code);
  json["error"]["message"] = error.message;
  json["error"]["where"] = error.index < 0 ? Json(nullptr) : Json(error.index);
  return text_of(json);
}

}  // namespace inkflate
