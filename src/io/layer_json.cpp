// SPDX-License-Identifier: Apache-2.0
#include "io/layer_json.h"

#include <utility>

#include "io/sketch_limits.h"
#include "io/stroke_json.h"

namespace inkflate {
namespace {

using Json = nlohmann::ordered_json;

Json kinds_json(std::vector<OutlinePiece> const& pieces) {
  Json kinds = Json::array();
  for (std::size_t i = 0, next = 0; i < pieces.size(); i = next) {
    while (next < pieces.size() && pieces[next].kind == pieces[i].kind) ++next;
    kinds.push_back(Json::array({word(pieces[i].kind), next - i}));
  }
  return kinds;
}

}  // namespace

Json outline_json(Outline const& outline) {
  std::vector<Vec2> points;
  if (!outline.pieces.empty()) points.push_back(outline.pieces[0].curve.start());
  for (auto const& piece : outline.pieces) {
    auto const& control = piece.curve.control;
    points.insert(points.end(), control.begin() + 1, control.end());
  }
  Json sources = Json::array();
  for (auto const& source : outline.sources) {
    sources.push_back(
        Json::array({source.from, source.to, source.stroke, source.sample_from, source.sample_to}));
  }
  Json json;
  json["points"] = points_json(points);
  json["kinds"] = kinds_json(outline.pieces);
  json["sources"] = std::move(sources);
  return json;
}

namespace {

void take_kinds(JsonTaker& take, nlohmann::json const& json, std::vector<OutlinePiece>& pieces) {
  std::size_t next = 0;
  for (auto const& run : take.list(json, "kinds")) {
    auto const* const pair = take.tuple(&run, "a run", 2);
    if (pair == nullptr) return;
    auto const kind =
        take.kind(pair->data(), "kind", {RunKind::Ink, RunKind::HelpLine, RunKind::Closing});
    int const size = take.index(&(*pair)[1], "the size of a run", 0, std::ssize(pieces) + 1);
    for (int i = 0; i < size && next < pieces.size(); ++i) pieces[next++].kind = kind;
  }
  if (next != pieces.size()) take.fail("an outline has not one kind for each curve");
}

std::vector<OutlinePiece> take_pieces(JsonTaker& take, nlohmann::json const& json) {
  auto const corners = take.points(json, "points", kCoordinateLimit);
  std::size_t const count = corners.empty() ? 0 : (corners.size() - 1) / 3;
  bool const is_chain = corners.empty() || (corners.size() == 3 * count + 1 && count > 0 &&
                                            corners.front() == corners.back());
  if (!is_chain) {
    take.fail("the points of an outline are no closed chain of curves");
    return {};
  }
  std::vector<OutlinePiece> pieces(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 4; ++k) pieces[i].curve.control[k] = corners[3 * i + k];
  }
  take_kinds(take, json, pieces);
  return pieces;
}

}  // namespace

Outline take_outline(JsonTaker& take, nlohmann::json const& json, std::ptrdiff_t stroke_count) {
  Outline outline;
  outline.pieces = take_pieces(take, json);
  for (auto const& source : take.list(json, "sources")) {
    auto const* const values = take.tuple(&source, "a source", 5);
    if (values == nullptr) break;
    auto const value = [&](std::size_t i) {
      return take.number(&(*values)[i], "source", -kAnyNumber, kAnyNumber);
    };
    InkSource read;
    read.from = value(0);
    read.to = value(1);
    read.stroke = take.index(&(*values)[2], "the stroke of a source", -1, stroke_count);
    read.sample_from = value(3);
    read.sample_to = value(4);
    outline.sources.push_back(read);
  }
  return outline;
}

Json choice_json(CloseChoice const& choice) {
  Json json = Json::object();
  if (choice.gap_px) json["gap"] = *choice.gap_px;
  if (!choice.outside.empty()) json["outside"] = points_json(choice.outside);
  if (!choice.inside.empty()) json["inside"] = points_json(choice.inside);
  return json;
}

CloseChoice take_choice(JsonTaker& take, nlohmann::json const& json) {
  if (!json.is_object()) take.fail("choice is no object");
  CloseChoice choice;
  if (auto const* const gap = take.find(json, "gap")) {
    choice.gap_px =
        take.number(gap, "gap", std::numeric_limits<double>::denorm_min(), kCoordinateLimit);
  }
  choice.outside = take.points(json, "outside", kCoordinateLimit);
  choice.inside = take.points(json, "inside", kCoordinateLimit);
  return choice;
}

Json bend_pin_json(BendPin const& pin) {
  Json json;
  json["position"] = Json::array({pin.position.x, pin.position.y});
  if (pin.turn_rad) json["turn"] = *pin.turn_rad;
  return json;
}

std::vector<BendPin> take_bend_pins(JsonTaker& take, nlohmann::json const& json, char const* name) {
  std::vector<BendPin> pins;
  for (auto const& value : take.list(json, name)) {
    auto& pin = pins.emplace_back();
    pin.position = take.point(take.find(value, "position"), "position", kCoordinateLimit);
    if (auto const* const turn = take.find(value, "turn")) {
      pin.turn_rad = take.number(turn, "turn", -kAnyNumber, kAnyNumber);
    }
  }
  return pins;
}

Json layer_json(Layer const& layer) {
  Json outlines = Json::array();
  for (auto const& outline : layer.outlines) outlines.push_back(outline_json(outline));
  Json json = look_json(layer.name, layer.fill, layer.thickness);
  if (layer.id != LayerId::None) json["id"] = static_cast<int>(layer.id);
  if (layer.is_hidden) json["hidden"] = true;
  if (layer.is_locked) json["locked"] = true;
  if (layer.is_open) json["open"] = true;
  if (layer.choice != CloseChoice{}) json["choice"] = choice_json(layer.choice);
  json["outlines"] = std::move(outlines);
  json["strokes"] = layer.strokes;
  json["details"] = layer.details;
  if (!layer.noise.empty()) json["noise"] = layer.noise;
  for (auto const& pin : layer.bend_pins) json["bend_pins"].push_back(bend_pin_json(pin));
  return json;
}

Layer take_layer(JsonTaker& take, nlohmann::json const& json, std::ptrdiff_t stroke_count) {
  Layer layer;
  take_look(take, json, layer.name, layer.fill, layer.thickness);
  if (auto const* const id = take.find(json, "id")) {
    layer.id = LayerId{take.index(id, "id", 1, kAnyCount)};
  }
  layer.is_hidden = take.flag(json, "hidden");
  layer.is_locked = take.flag(json, "locked");
  layer.is_open = take.flag(json, "open");
  if (auto const* const choice = take.find(json, "choice")) {
    layer.choice = take_choice(take, *choice);
  }
  for (auto const& outline : take.list(json, "outlines")) {
    layer.outlines.push_back(take_outline(take, outline, stroke_count));
  }
  layer.strokes = take.indices(json, "strokes", 0, stroke_count);
  layer.details = take.indices(json, "details", 0, stroke_count);
  layer.noise = take.indices(json, "noise", 0, stroke_count);
  layer.bend_pins = take_bend_pins(take, json, "bend_pins");
  return layer;
}

}  // namespace inkflate
