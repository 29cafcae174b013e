// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "io/json_taker.h"
#include "model/drawing.h"

namespace inkflate {

/// Layers and what they hold as JSON, in documents and in commands alike; docs/FORMATS.md. Each x_json is read back by take_x.

inline std::string_view word(RunKind kind) {
  return kind == RunKind::Ink ? "ink" : kind == RunKind::HelpLine ? "help" : "closing";
}

nlohmann::ordered_json outline_json(Outline const& outline);
/// stroke_count: as for take_layer.
Outline take_outline(JsonTaker& take, nlohmann::json const& json, std::ptrdiff_t stroke_count);

nlohmann::ordered_json choice_json(CloseChoice const& choice);
CloseChoice take_choice(JsonTaker& take, nlohmann::json const& json);

nlohmann::ordered_json bend_pin_json(BendPin const& pin);
/// The list that a member of an object is; none where there is no such member.
std::vector<BendPin> take_bend_pins(JsonTaker& take, nlohmann::json const& json, char const* name);

nlohmann::ordered_json layer_json(Layer const& layer);
/// stroke_count: of the list into which its strokes are indices.
Layer take_layer(JsonTaker& take, nlohmann::json const& json, std::ptrdiff_t stroke_count);

}  // namespace inkflate
