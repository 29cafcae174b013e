// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>
#include <variant>

#include "io/base64.h"
#include "io/clip_json.h"
#include "io/command_json.h"
#include "io/command_members.h"
#include "io/json_taker.h"
#include "io/layer_json.h"
#include "io/parse_json.h"
#include "io/read_document_json.h"
#include "io/read_picture.h"
#include "io/stroke_json.h"

namespace inkflate {
namespace {

using Json = nlohmann::json;

/// Takes the members of a command. An id that is missing is none; a list or colour that is missing is empty.
class MemberReader {
 public:
  MemberReader(JsonTaker& take, Json const& json) : take_(take), json_(json) {}

  void operator()(char const* name, double& value) {
    value = take_.number(take_.find(json_, name), name, -kAnyNumber, kAnyNumber);
  }
  void operator()(char const* name, bool& value) { value = take_.flag(json_, name); }
  void operator()(char const* name, std::string& value) {
    value = take_.text(take_.find(json_, name), name);
  }
  void operator()(char const* name, Vec2& value) {
    value = take_.point(take_.find(json_, name), name, kAnyNumber);
  }
  void operator()(char const* name, Polyline& value) {
    value = take_.points(json_, name, kAnyNumber);
  }
  void operator()(char const* name, Affine& map) {
    auto const* const values = take_.tuple(take_.find(json_, name), name, 6);
    if (values == nullptr) return;
    std::size_t i = 0;
    for (auto* const value : {&map.a, &map.b, &map.c, &map.d, &map.e, &map.f}) {
      *value = take_.number(&(*values)[i++], name, -kAnyNumber, kAnyNumber);
    }
  }
  void operator()(char const* name, std::optional<Colour>& value) {
    if (auto const* const found = take_.find(json_, name)) value = take_.colour(found, name);
  }
  void operator()(char const* name, LayerId& value) {
    if (auto const* const found = take_.find(json_, name)) value = take_id(found, name);
  }
  template <typename Id>
  void operator()(char const* name, std::vector<Id>& ids) {
    for (int const id : take_.indices(json_, name, 0, kAnyCount)) ids.push_back(Id{id});
  }
  void operator()(char const* name, OrderEnd& value) {
    value = take_.kind(take_.find(json_, name), name, {OrderEnd::Back, OrderEnd::Front});
  }
  void operator()(char const* name, Stroke& value) {
    value = take_stroke(take_, member(name), kAnyCount);
  }
  void operator()(char const* name, CloseChoice& value) {
    value = take_choice(take_, member(name));
  }
  void operator()(char const* name, Pin& value) { value = take_pin(take_, member(name)); }
  void operator()(char const* name, Track& value) { value = take_track(take_, member(name)); }
  void operator()(char const* name, std::vector<StrokeRef>& refs);
  void operator()(char const* name, std::vector<Simplify::Set>& sets);
  void operator()(char const* name, std::vector<Simplify::Details>& details);
  void operator()(char const* name, std::vector<Bend::Part>& parts);
  void operator()(char const* name, std::vector<Bend::Line>& lines);
  void operator()(char const* name, std::vector<BendPin>& pins) {
    pins = take_bend_pins(take_, json_, name);
  }
  void operator()(char const* name, Shared<Picture>& picture);
  void operator()(char const* name, Document& document);

 private:
  Json const& member(char const* name) const {
    auto const* const found = take_.find(json_, name);
    return found == nullptr ? none_ : *found;
  }

  LayerId take_id(Json const* value, char const* name) {
    return LayerId{take_.index(value, name, 0, kAnyCount)};
  }

  StrokeRef take_ref(Json const* value, char const* name) {
    auto const* const pair = take_.tuple(value, name, 2);
    if (pair == nullptr) return {};
    return {take_id(pair->data(), name), take_.index(&(*pair)[1], name, 0, kAnyCount)};
  }

  JsonTaker& take_;
  Json const& json_;
  Json const none_;
};

void MemberReader::operator()(char const* name, std::vector<StrokeRef>& refs) {
  for (auto const& value : take_.list(json_, name)) refs.push_back(take_ref(&value, name));
}

void MemberReader::operator()(char const* name, std::vector<Simplify::Set>& sets) {
  for (auto const& value : take_.list(json_, name)) {
    take_.enter("set", std::ssize(sets));
    auto& set = sets.emplace_back();
    if (auto const* const layer = take_.find(value, "layer")) set.layer = take_id(layer, "layer");
    set.strokes = take_.indices(value, "strokes", 0, kAnyCount);
    if (auto const* const depth = take_.find(value, "depth")) {
      set.depth = take_.kind(depth, "depth", {StrokeDepth::Near, StrokeDepth::Far});
    }
    for (auto const& shape : take_.list(value, "shapes")) {
      set.shapes.push_back(take_layer(take_, shape, kAnyCount));
    }
  }
}

void MemberReader::operator()(char const* name, std::vector<Simplify::Details>& details) {
  for (auto const& value : take_.list(json_, name)) {
    take_.enter("details", std::ssize(details));
    details.push_back({take_id(take_.find(value, "layer"), "layer"),
                       take_.indices(value, "strokes", 0, kAnyCount)});
  }
}

void MemberReader::operator()(char const* name, std::vector<Bend::Part>& parts) {
  for (auto const& value : take_.list(json_, name)) {
    take_.enter("part", std::ssize(parts));
    auto& part = parts.emplace_back();
    part.layer = take_id(take_.find(value, "layer"), "layer");
    for (auto const& outline : take_.list(value, "outlines")) {
      part.outlines.push_back(take_outline(take_, outline, kAnyCount));
    }
    part.samples = take_.points(value, "samples", kAnyNumber);
    part.marks = take_.points(value, "marks", kAnyNumber);
  }
}

void MemberReader::operator()(char const* name, std::vector<Bend::Line>& lines) {
  for (auto const& value : take_.list(json_, name)) {
    take_.enter("line", std::ssize(lines));
    lines.push_back({take_ref(take_.find(value, "stroke"), "stroke"),
                     take_.points(value, "samples", kAnyNumber)});
  }
}

void MemberReader::operator()(char const* name, Shared<Picture>& picture) {
  auto const* const found = take_.find(json_, name);
  if (found == nullptr) return;
  auto const png = parse_base64(take_.text(found, name));
  if (!png) return take_.fail(std::string(name) + " is no base64");
  auto read = read_picture(*png);
  if (!read) return take_.fail(std::string(name) + ": " + read.error().message, read.error().code);
  picture = std::make_shared<Picture const>(*std::move(read));
}

void MemberReader::operator()(char const* name, Document& document) {
  auto file = take_document(member(name));
  if (!file) return take_.fail(file.error().message, file.error().code);
  auto made = make_document(file->project);
  if (!made) return take_.fail(made.error().message, made.error().code);
  document = *std::move(made);
  (*this)("picture", document.template_picture);
}

/// Tries one command after the other until the name fits.
template <std::size_t... index>
std::optional<Command> take_named(JsonTaker& take, Json const& json, std::string_view name,
                                  std::index_sequence<index...> /*of Command*/) {
  std::optional<Command> found;
  auto const try_one = [&]<typename C>(C command) {
    if (CommandText<C>::kName != name) return false;
    MemberReader reader(take, json);
    CommandText<C>::members(reader, command);
    found = std::move(command);
    return true;
  };
  static_cast<void>((try_one(std::variant_alternative_t<index, Command>{}) || ...));
  return found;
}

}  // namespace

Result<Command> take_command(Json const& json) {
  JsonTaker take("command");
  auto const name = take.text(take.find(json, "command"), "command");
  auto command =
      take_named(take, json, name, std::make_index_sequence<std::variant_size_v<Command>>());
  if (!command) take.fail("there is no command \"" + name.substr(0, 20) + "\"");
  if (take.fault()) return *take.fault();
  return *std::move(command);
}

Result<Command> read_command(std::string_view text) {
  auto const json = parse_json(text);
  if (!json) return Error{json.error().code, "command: " + json.error().message};
  return take_command(*json);
}

}  // namespace inkflate
