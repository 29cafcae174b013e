// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/json_taker.h"
#include "model/stroke.h"

namespace inkflate {

/// Strokes and groups as JSON, in documents and in commands alike; docs/FORMATS.md. Each x_json is read back by take_x.

inline std::string_view word(StrokeKind kind) { return kind == StrokeKind::Ink ? "ink" : "help"; }
inline std::string_view word(StrokeDepth depth) {
  return depth == StrokeDepth::Near ? "near" : "far";
}

/// [x0, y0, x1, y1, ...]
nlohmann::ordered_json points_json(std::span<Vec2 const> points);

nlohmann::ordered_json stroke_json(Stroke const& stroke);
Stroke take_stroke(JsonTaker& take, nlohmann::json const& json, std::ptrdiff_t group_count);

/// What groups and layers have in common.
nlohmann::ordered_json look_json(std::string const& name, std::optional<Colour> const& fill,
                                 double thickness);
void take_look(JsonTaker& take, nlohmann::json const& json, std::string& name,
               std::optional<Colour>& fill, double& thickness);

nlohmann::ordered_json group_json(StrokeGroup const& group);
StrokeGroup take_group(JsonTaker& take, nlohmann::json const& json);

}  // namespace inkflate
