// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/json_taker.h"
#include "model/clip.h"

namespace inkflate {

/// Pins and tracks as JSON, in documents and in commands alike; docs/FORMATS.md. Each x_json is read back by take_x.

inline std::string_view word(Side side) { return side == Side::Front ? "front" : "back"; }

nlohmann::ordered_json point_json(Vec2 point);

nlohmann::ordered_json pin_json(Pin const& pin);
Pin take_pin(JsonTaker& take, nlohmann::json const& json);

nlohmann::ordered_json track_json(Track const& track);
Track take_track(JsonTaker& take, nlohmann::json const& json);

nlohmann::ordered_json clip_json(Clip const& clip);
Clip take_clip(JsonTaker& take, nlohmann::json const& json);

}  // namespace inkflate
