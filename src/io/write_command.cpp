// SPDX-License-Identifier: Apache-2.0
#include <variant>

#include "io/base64.h"
#include "io/clip_json.h"
#include "io/command_json.h"
#include "io/command_members.h"
#include "io/layer_json.h"
#include "io/stroke_json.h"
#include "io/svg_colour.h"
#include "io/write_document_json.h"
#include "io/write_png.h"

namespace inkflate {
namespace {

using Json = nlohmann::ordered_json;

Json stroke_ref_json(StrokeRef ref) {
  return Json::array({static_cast<int>(ref.layer), ref.index});
}

Json bent_part_json(Bend::Part const& part) {
  Json json;
  json["layer"] = static_cast<int>(part.layer);
  json["outlines"] = Json::array();
  for (auto const& outline : part.outlines) json["outlines"].push_back(outline_json(outline));
  json["samples"] = points_json(part.samples);
  if (!part.marks.empty()) json["marks"] = points_json(part.marks);
  return json;
}

Json bent_line_json(Bend::Line const& line) {
  return {{"stroke", stroke_ref_json(line.stroke)}, {"samples", points_json(line.samples)}};
}

Json set_json(Simplify::Set const& set) {
  Json json;
  if (set.layer != LayerId::None) json["layer"] = static_cast<int>(set.layer);
  if (!set.strokes.empty()) json["strokes"] = set.strokes;
  if (set.depth != StrokeDepth::Near) json["depth"] = word(set.depth);
  json["shapes"] = Json::array();
  for (auto const& shape : set.shapes) json["shapes"].push_back(layer_json(shape));
  return json;
}

/// Puts the members of a command, those that are none excepted.
class MemberWriter {
 public:
  explicit MemberWriter(Json& json) : json_(json) {}

  void operator()(char const* name, double value) { json_[name] = value; }
  void operator()(char const* name, bool value) { json_[name] = value; }
  void operator()(char const* name, std::string const& value) { json_[name] = value; }
  void operator()(char const* name, Vec2 value) { json_[name] = point_json(value); }
  void operator()(char const* name, Polyline const& value) { json_[name] = points_json(value); }
  void operator()(char const* name, Affine const& map) {
    json_[name] = Json::array({map.a, map.b, map.c, map.d, map.e, map.f});
  }
  void operator()(char const* name, std::optional<Colour> const& value) {
    if (value) json_[name] = colour_hex(*value);
  }
  void operator()(char const* name, LayerId value) {
    if (value != LayerId::None) json_[name] = static_cast<int>(value);
  }
  template <typename Id>
  void operator()(char const* name, std::vector<Id> const& ids) {
    json_[name] = Json::array();
    for (auto const id : ids) json_[name].push_back(static_cast<int>(id));
  }
  void operator()(char const* name, OrderEnd value) { json_[name] = word(value); }
  void operator()(char const* name, Stroke const& value) { json_[name] = stroke_json(value); }
  void operator()(char const* name, CloseChoice const& value) { json_[name] = choice_json(value); }
  void operator()(char const* name, Pin const& value) { json_[name] = pin_json(value); }
  void operator()(char const* name, Track const& value) { json_[name] = track_json(value); }
  void operator()(char const* name, std::vector<StrokeRef> const& value) {
    json_[name] = Json::array();
    for (auto const ref : value) json_[name].push_back(stroke_ref_json(ref));
  }
  void operator()(char const* name, std::vector<Simplify::Set> const& sets) {
    json_[name] = Json::array();
    for (auto const& set : sets) json_[name].push_back(set_json(set));
  }
  void operator()(char const* name, std::vector<Simplify::Details> const& details) {
    for (auto const& [layer, strokes] : details) {
      json_[name].push_back({{"layer", static_cast<int>(layer)}, {"strokes", strokes}});
    }
  }
  void operator()(char const* name, std::vector<Bend::Part> const& parts) {
    json_[name] = Json::array();
    for (auto const& part : parts) json_[name].push_back(bent_part_json(part));
  }
  void operator()(char const* name, std::vector<Bend::Line> const& lines) {
    for (auto const& line : lines) json_[name].push_back(bent_line_json(line));
  }
  void operator()(char const* name, std::vector<BendPin> const& pins) {
    json_[name] = Json::array();
    for (auto const& pin : pins) json_[name].push_back(bend_pin_json(pin));
  }
  void operator()(char const* name, Shared<Picture> const& picture) {
    if (!picture) return;
    // One without pixels, which no document takes, is no PNG, and no reader takes it either.
    json_[name] = picture->values.empty() ? std::string() : base64_of(write_png(*picture));
  }
  void operator()(char const* name, Document const& document) {
    json_[name] = document_json(to_project(document));
    (*this)("picture", document.template_picture);
  }

 private:
  Json& json_;
};

}  // namespace

Json command_json(Command const& command) {
  Json json;
  std::visit(
      [&]<typename C>(C const& each) {
        json["command"] = CommandText<C>::kName;
        MemberWriter writer(json);
        CommandText<C>::members(writer, each);
      },
      command);
  return json;
}

std::string write_command(Command const& command) { return json_text(command_json(command)); }

}  // namespace inkflate
