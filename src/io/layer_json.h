// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/json_taker.h"
#include "model/drawing.h"

namespace inkflate {

/// Layers and choices as JSON, in documents and in commands alike; docs/FORMATS.md. Each x_json is read back by take_x.

inline std::string_view word(RunKind kind) {
  return kind == RunKind::Ink ? "ink" : kind == RunKind::HelpLine ? "help" : "closing";
}

nlohmann::ordered_json choice_json(CloseChoice const& choice);
CloseChoice take_choice(JsonTaker& take, nlohmann::json const& json);

nlohmann::ordered_json layer_json(Layer const& layer);
/// stroke_count: of the list into which its strokes are indices.
Layer take_layer(JsonTaker& take, nlohmann::json const& json, std::ptrdiff_t stroke_count);

}  // namespace inkflate
