// SPDX-License-Identifier: Apache-2.0
#include "cli/pin_list.h"

#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

#include "cli/event_line.h"
#include "cli/option_values.h"
#include "document/apply.h"
#include "io/parse_json.h"

namespace inkflate::cli {
namespace {

constexpr double kMostTurnDeg = 3600;  // ten times around: more is a slip

bool is_on_sheet(Vec2 p) {
  // Also false for NaN.
  return std::abs(p.x) <= DocumentLimits::kFarthestPx &&
         std::abs(p.y) <= DocumentLimits::kFarthestPx;
}

/// What is wrong with the numbers of a pin; empty: nothing.
std::string number_fault(PinWords const& pin) {
  if (!is_on_sheet(pin.at) || !is_on_sheet(pin.to.value_or(Vec2{}))) {
    return "lies farther than 1 000 000 px from the canvas";
  }
  if (std::abs(pin.turn_deg.value_or(0)) <= kMostTurnDeg) return "";
  return "turns by more than 3600 degrees";
}

/// A part by its name or its number.
std::string take_part(EventLine& line, nlohmann::json const& json) {
  auto const part = json.find("part");
  if (part == json.end() || part->is_string()) return line.text("part", "");
  return std::to_string(line.whole_number("part", 0));
}

/// errors  BadInput: without its source
Result<PinWords> take_pin(nlohmann::json const& json) {
  if (!json.is_object()) return Error{ErrorCode::BadInput, "is no JSON object"};
  EventLine line(json);
  PinWords pin;
  pin.part = take_part(line, json);
  pin.at = line.point("at");
  if (line.has("to")) pin.to = line.point("to");
  if (line.has("turn")) pin.turn_deg = line.number("turn", 0);
  if (auto const fault = line.fault()) return Error{ErrorCode::BadInput, *fault};
  if (auto fault = number_fault(pin); !fault.empty()) {
    return Error{ErrorCode::BadInput, std::move(fault)};
  }
  return pin;
}

/// The text cut at its last colon: what lies after it, and what is left before it.
std::string cut_last(std::string& text) {
  auto const colon = text.rfind(':');
  auto last = colon == std::string::npos ? std::exchange(text, "") : text.substr(colon + 1);
  if (colon != std::string::npos) text.resize(colon);
  return last;
}

std::optional<Vec2> last_point(std::string& text) {
  if (text.find(':') == std::string::npos) return std::nullopt;
  auto rest = text;
  auto const point = parse_point("", cut_last(rest));
  if (!point) return std::nullopt;
  text = std::move(rest);
  return *point;
}

}  // namespace

Result<PinFile> read_pins(std::string_view text, std::string const& name) {
  auto const json = parse_json(text);
  if (!json) return Error{json.error().code, name + ": " + json.error().message};
  auto const bad = [&](std::string const& what) {
    return Error{ErrorCode::BadInput, name + ": " + what};
  };
  auto const list = json->is_object() ? json->find("pins") : json->end();
  if (!json->is_object() || list == json->end() || !list->is_array()) {
    return bad("wants {\"pins\": [{\"at\": [x, y], \"to\": [x, y]}, ...]}");
  }
  if (std::ssize(*list) > kMaxPins) {
    return Error{ErrorCode::TooLarge, name + ": more than 1024 pins"};
  }
  EventLine line(*json);
  line.is_null("pins");
  PinFile file;
  if (line.has("mode")) {
    file.mode = line.choice<BendMode>("mode", BendMode::Body,
                                      {{"body", BendMode::Body}, {"wire", BendMode::Wire}});
  }
  if (line.has("body")) file.body = line.number("body", 1);
  if (auto const fault = line.fault()) return bad(*fault);
  if (file.body) {
    if (auto const body = checked_body("\"body\"", file.body); !body)
      return bad(body.error().message);
  }
  for (auto const& each : *list) {
    auto const source = name + ": pin " + std::to_string(std::ssize(file.pins) + 1);
    auto pin = take_pin(each);
    if (!pin) {
      return Error{ErrorCode::BadInput, source + ": " + pin.error().message, std::ssize(file.pins)};
    }
    pin->source = source;
    file.pins.push_back(*std::move(pin));
  }
  return file;
}

Result<PinWords> parse_pin(std::string const& text, int number) {
  auto const source = "--pin " + std::to_string(number);
  auto const bad = [&](std::string const& what) {
    return Error{ErrorCode::BadOption, source + " " + what + ": " + text};
  };
  PinWords pin = {source, text, {}};
  auto rest = text;
  if (auto const turn = parse_number(cut_last(rest)); turn && last_point(rest)) {
    pin.turn_deg = turn;
    pin.part.resize(text.rfind(':'));
  }
  auto const last = last_point(pin.part);
  if (!last) return bad("wants PART:X,Y:X,Y or PART:X,Y:X,Y:DEGREES, not");
  pin.at = *last;
  if (auto const first = last_point(pin.part)) {
    pin.at = *first;
    pin.to = *last;
  }
  if (auto const fault = number_fault(pin); !fault.empty()) return bad(fault);
  return pin;
}

Result<double> checked_body(std::string const& what, std::optional<double> body) {
  if (body && *body >= BendOptions::kLeastBody && *body <= 1) return *body;
  std::ostringstream message;
  message << what << " wants a number from " << BendOptions::kLeastBody << " to 1";
  return Error{ErrorCode::BadOption, message.str()};
}

}  // namespace inkflate::cli
