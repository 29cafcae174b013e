// SPDX-License-Identifier: Apache-2.0
#include "io/stroke_json.h"

#include <algorithm>
#include <utility>

#include "io/sketch_limits.h"
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

void take_per_sample(JsonTaker& take, nlohmann::json const& json, char const* name,
                     double Sample::*member, double most, std::vector<Sample>& samples) {
  if (take.find(json, name) == nullptr) return;
  auto const& numbers = take.list(json, name);
  if (numbers.size() != samples.size())
    return take.fail(std::string(name) + " are not one for each position");
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    samples[i].*member = take.number(&numbers[i], name, 0, most);
  }
}

}  // namespace

Json points_json(std::span<Vec2 const> points) {
  Json numbers = Json::array();
  for (auto const point : points) {
    numbers.push_back(point.x);
    numbers.push_back(point.y);
  }
  return numbers;
}

Json stroke_json(Stroke const& stroke) {
  std::vector<Vec2> positions;
  positions.reserve(stroke.samples.size());
  for (auto const& sample : stroke.samples) positions.push_back(sample.position);
  Json json;
  json["kind"] = word(stroke.kind);
  json["width"] = stroke.width_px;
  json["colour"] = colour_hex(stroke.colour);
  if (stroke.group >= 0) json["group"] = stroke.group;
  if (stroke.depth != StrokeDepth::Near) json["depth"] = word(stroke.depth);
  json["positions"] = points_json(positions);
  put_per_sample(json, "pressures", stroke.samples, &Sample::pressure, 1);
  put_per_sample(json, "times", stroke.samples, &Sample::time_s, 0);
  return json;
}

Stroke take_stroke(JsonTaker& take, nlohmann::json const& json, std::ptrdiff_t group_count) {
  Stroke stroke;
  stroke.kind = take.kind(take.find(json, "kind"), "kind", {StrokeKind::Ink, StrokeKind::HelpLine});
  stroke.width_px = take.number(take.find(json, "width"), "width", 0, kCoordinateLimit);
  stroke.colour = take.colour(take.find(json, "colour"), "colour");
  if (auto const* const group = take.find(json, "group")) {
    stroke.group = take.index(group, "group", 0, group_count);
  }
  if (auto const* const depth = take.find(json, "depth")) {
    stroke.depth = take.kind(depth, "depth", {StrokeDepth::Near, StrokeDepth::Far});
  }
  for (auto const position : take.points(json, "positions", kCoordinateLimit)) {
    stroke.samples.push_back({position});
  }
  take_per_sample(take, json, "pressures", &Sample::pressure, 1, stroke.samples);
  take_per_sample(take, json, "times", &Sample::time_s, kAnyNumber, stroke.samples);
  return stroke;
}

Json look_json(std::string const& name, std::optional<Colour> const& fill, double thickness) {
  Json json;
  json["name"] = name;
  if (fill) json["fill"] = colour_hex(*fill);
  json["thickness"] = thickness;
  return json;
}

void take_look(JsonTaker& take, nlohmann::json const& json, std::string& name,
               std::optional<Colour>& fill, double& thickness) {
  name = take.text(take.find(json, "name"), "name");
  if (auto const* const value = take.find(json, "fill")) fill = take.colour(value, "fill");
  if (auto const* const value = take.find(json, "thickness")) {
    thickness = take.number(value, "thickness", kLeastThickness, kLargestThickness);
  }
}

Json group_json(StrokeGroup const& group) {
  return look_json(group.name, group.fill, group.thickness);
}

StrokeGroup take_group(JsonTaker& take, nlohmann::json const& json) {
  StrokeGroup group;
  take_look(take, json, group.name, group.fill, group.thickness);
  return group;
}

}  // namespace inkflate
