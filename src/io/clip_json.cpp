// SPDX-License-Identifier: Apache-2.0
#include "io/clip_json.h"

#include <utility>

#include "io/sketch_limits.h"
#include "io/stroke_json.h"

namespace inkflate {

using Json = nlohmann::ordered_json;

Json point_json(Vec2 point) { return Json::array({point.x, point.y}); }

Json pin_json(Pin const& pin) {
  Json json;
  if (pin.id != PinId::None) json["id"] = static_cast<int>(pin.id);
  json["layer"] = static_cast<int>(pin.layer);
  if (pin.side != Side::Front) json["side"] = word(pin.side);
  json["rest"] = point_json(pin.rest);
  json["position"] = point_json(pin.position);
  return json;
}

Pin take_pin(JsonTaker& take, nlohmann::json const& json) {
  Pin pin;
  if (auto const* const id = take.find(json, "id")) {
    pin.id = PinId{take.index(id, "id", 1, kAnyCount)};
  }
  pin.layer = LayerId{take.index(take.find(json, "layer"), "layer", 0, kAnyCount)};
  if (auto const* const side = take.find(json, "side")) {
    pin.side = take.kind(side, "side", {Side::Front, Side::Back});
  }
  pin.rest = take.point(take.find(json, "rest"), "rest", kCoordinateLimit);
  pin.position = take.point(take.find(json, "position"), "position", kCoordinateLimit);
  return pin;
}

Json track_json(Track const& track) {
  Json times = Json::array();
  std::vector<Vec2> positions;
  for (auto const& key : track.keys) {
    times.push_back(key.time_s);
    positions.push_back(key.position);
  }
  Json json;
  json["pin"] = static_cast<int>(track.pin);
  if (track.phase_s != 0) json["phase"] = track.phase_s;
  json["times"] = std::move(times);
  json["positions"] = points_json(positions);
  return json;
}

Track take_track(JsonTaker& take, nlohmann::json const& json) {
  Track track;
  track.pin = PinId{take.index(take.find(json, "pin"), "pin", 0, kAnyCount)};
  if (auto const* const phase = take.find(json, "phase")) {
    track.phase_s = take.number(phase, "phase", -kAnyNumber, kAnyNumber);
  }
  auto const& times = take.list(json, "times");
  auto const positions = take.points(json, "positions", kCoordinateLimit);
  if (times.size() != positions.size()) {
    take.fail("a track has not one time for each position");
    return track;
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    double const time_s = take.number(&times[i], "times", 0, kAnyNumber);
    if (i > 0 && time_s <= track.keys.back().time_s)
      take.fail("the times of a track do not ascend");
    track.keys.push_back({time_s, positions[i]});
  }
  return track;
}

Json clip_json(Clip const& clip) {
  Json json;
  json["length"] = clip.length_s;
  json["tracks"] = Json::array();
  for (auto const& track : clip.tracks) json["tracks"].push_back(track_json(track));
  return json;
}

Clip take_clip(JsonTaker& take, nlohmann::json const& json) {
  Clip clip;
  clip.length_s = take.number(take.find(json, "length"), "length", 0, kAnyNumber);
  for (auto const& track : take.list(json, "tracks")) {
    take.enter("track", std::ssize(clip.tracks));
    clip.tracks.push_back(take_track(take, track));
    auto const& keys = clip.tracks.back().keys;
    if (!keys.empty() && keys.back().time_s > clip.length_s) {
      take.fail("a key lies beyond the end of the clip");
    }
  }
  return clip;
}

}  // namespace inkflate
