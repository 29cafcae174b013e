// SPDX-License-Identifier: Apache-2.0
#include "cli/pin_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "cli/option_values.h"
#include "geometry/segment.h"
#include "geometry/trig.h"

namespace inkflate::cli {
namespace {

constexpr double kTolerancePx = 0.05;  // far below what anybody reads off a picture

constexpr std::size_t kMostNamed = 8;  // parts of one message

std::string in_quotes(std::string const& name) { return "\"" + name + "\""; }

Error nothing_closed() {
  return {ErrorCode::BadInput, "there is no closed shape to bend; simplify it first"};
}

/// The nearest place of a part's line.
struct Hit {
  Layer const* layer = nullptr;
  Vec2 place;
  double squared_px = std::numeric_limits<double>::infinity();
};

void look_at(Layer const& layer, Vec2 at, Hit& best) {
  for (auto const& outline : layer.outlines) {
    auto const points = flatten(outline, kTolerancePx);
    for (std::size_t i = 0; i < points.size(); ++i) {
      Vec2 const place = nearest_on_segment(at, points[i], points[(i + 1) % points.size()]);
      double const squared_px = dot(place - at, place - at);
      if (squared_px < best.squared_px) best = {&layer, place, squared_px};
    }
  }
}

/// The parts that there are, back to front: 1 "tail", 2 "body", ...
std::string named_parts(Document const& document) {
  auto const& layers = *document.layers;
  std::string names;
  for (std::size_t i = 0; i < layers.size() && i < kMostNamed; ++i) {
    names += (i == 0 ? "" : ", ") + std::to_string(i + 1) + ' ' + in_quotes(layers[i]->layer.name);
  }
  return layers.size() > kMostNamed ? names + ", ..." : names;
}

/// The part that a name or a number means. errors: BadInput
Result<Layer const*> named_part(Document const& document, std::string const& part) {
  Layer const* found = nullptr;
  for (auto const& each : *document.layers) {
    if (each->layer.name != part) continue;
    if (found != nullptr) {
      return Error{ErrorCode::BadInput,
                   "several parts are called " + in_quotes(part) + "; give the part's number"};
    }
    found = &each->layer;
  }
  if (found != nullptr) return found;
  auto const number = parse_number(part);
  auto const& layers = *document.layers;
  if (number && *number >= 1 && *number <= static_cast<double>(layers.size()) &&
      *number == std::floor(*number)) {
    return &layers[static_cast<std::size_t>(*number) - 1]->layer;
  }
  if (layers.empty()) return nothing_closed();
  return Error{ErrorCode::BadInput,
               "there is no part " + in_quotes(part) + "; there are " + named_parts(document)};
}

/// errors  BadInput: without the pin's source
Result<Hit> find_place(Document const& document, PinWords const& pin) {
  Hit best;
  if (pin.part.empty()) {
    for (auto const& each : *document.layers) {
      if (!each->layer.is_hidden) look_at(each->layer, pin.at, best);
    }
  } else {
    auto const part = named_part(document, pin.part);
    if (!part) return part.error();
    look_at(**part, pin.at, best);
  }
  if (best.layer == nullptr) {
    return nothing_closed();
  }
  double const most_px = kPickShare * std::max(document.width_px, document.height_px);
  double const far_px = std::sqrt(best.squared_px);
  if (far_px <= most_px) return best;
  std::ostringstream message;
  message << "lies " << std::round(far_px) << " px from the line of "
          << (pin.part.empty() ? "the nearest part, " : "") << in_quotes(best.layer->name)
          << "; the line is nearest at " << std::round(best.place.x) << ","
          << std::round(best.place.y) << " (a pin may lie " << std::round(most_px) << " px off)";
  return Error{ErrorCode::BadInput, message.str()};
}

}  // namespace

Result<std::vector<BendMove>> pin_moves(Document const& document,
                                        std::vector<PinWords> const& pins) {
  std::vector<BendMove> moves;
  for (auto const& pin : pins) {
    auto const hit = find_place(document, pin);
    if (!hit) {
      return Error{hit.error().code, pin.source + ": " + hit.error().message, std::ssize(moves)};
    }
    BendMove move = {hit->layer->id, hit->place, pin.to.value_or(hit->place)};
    if (pin.turn_deg) move.turn_rad = *pin.turn_deg * kPi / 180;
    moves.push_back(move);
  }
  return moves;
}

}  // namespace inkflate::cli
