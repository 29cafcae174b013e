// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "document/apply.h"
#include "document/apply_one.h"
#include "document/check_values.h"
#include "document/edit_layer.h"
#include "document/edit_pins.h"

namespace inkflate {
namespace {

/// errors: NothingThere (none), BadInput (one is named twice or is not there)
Result<std::set<PinId>> existing_pins(Document const& document, std::vector<PinId> const& pins) {
  if (pins.empty()) return Error{ErrorCode::NothingThere, "no pin is selected"};
  std::set<PinId> known;
  for (auto const& pin : *document.pins) known.insert(pin.id);
  std::set<PinId> chosen;
  for (auto const pin : pins) {
    if (known.count(pin) == 0 || !chosen.insert(pin).second) {
      int const id = static_cast<int>(pin);
      return Error{ErrorCode::BadInput,
                   "there is no pin " + std::to_string(id) + ", or it is named twice", id};
    }
  }
  return chosen;
}

Document with_pins(Document document, std::vector<Pin> pins) {
  document.pins = std::make_shared<std::vector<Pin> const>(std::move(pins));
  return document;
}

Document with_clip(Document document, Clip clip) {
  document.clip = std::make_shared<Clip const>(std::move(clip));
  return document;
}

}  // namespace

Result<Document> apply_one(Document const& document, AddPin const& command) {
  if (auto const place = layer_place(document, command.pin.layer, Reach::Any); !place) {
    return place.error();
  }
  if (auto const fault = pin_fault(command.pin)) return *fault;
  if (std::ssize(*document.pins) >= DocumentLimits::kPins) {
    return Error{ErrorCode::TooLarge, "more than 1024 pins; remove some first"};
  }
  if (document.next_id >= DocumentLimits::kIds) return no_more_ids();
  auto pins = *document.pins;
  pins.push_back(command.pin);
  pins.back().id = static_cast<PinId>(document.next_id);
  auto result = with_pins(document, std::move(pins));
  ++result.next_id;
  return result;
}

Result<Document> apply_one(Document const& document, MovePins const& command) {
  auto const chosen = existing_pins(document, command.pins);
  if (!chosen) return chosen.error();
  if (command.positions.size() != command.pins.size()) {
    return Error{ErrorCode::BadInput, "not one position for each pin"};
  }
  auto pins = *document.pins;
  for (auto& pin : pins) {
    auto const named = std::find(command.pins.begin(), command.pins.end(), pin.id);
    if (named == command.pins.end()) continue;
    pin.position = command.positions[static_cast<std::size_t>(named - command.pins.begin())];
    if (auto fault = pin_fault(pin)) {
      fault->index = static_cast<int>(pin.id);
      return *fault;
    }
  }
  if (pins == *document.pins) return no_change();
  return with_pins(document, std::move(pins));
}

Result<Document> apply_one(Document const& document, DeletePins const& command) {
  auto const chosen = existing_pins(document, command.pins);
  if (!chosen) return chosen.error();
  return without_pins(document, *chosen);
}

Result<Document> apply_one(Document const& document, SetTrack const& command) {
  auto const& track = command.track;
  if (auto const pin = existing_pins(document, {track.pin}); !pin) return pin.error();
  if (auto fault = track_fault(track, document.clip->length_s)) {
    fault->index = static_cast<int>(track.pin);
    return *fault;
  }
  auto clip = *document.clip;
  auto const same_pin = [&](Track const& other) { return other.pin == track.pin; };
  auto const old = std::find_if(clip.tracks.begin(), clip.tracks.end(), same_pin);
  bool const was_there = old != clip.tracks.end();
  if (was_there ? *old == track : track.keys.empty()) return no_change();
  if (track.keys.empty()) {
    clip.tracks.erase(old);
  } else if (was_there) {
    *old = track;
  } else {
    clip.tracks.push_back(track);
  }
  return with_clip(document, std::move(clip));
}

Result<Document> apply_one(Document const& document, SetClipLength const& command) {
  if (auto const fault = clip_length_fault(command.length_s)) return *fault;
  for (auto const& track : document.clip->tracks) {
    if (!track.keys.empty() && track.keys.back().time_s > command.length_s) {
      return Error{ErrorCode::BadOption, "a key lies beyond that length; remove it first",
                   static_cast<int>(track.pin)};
    }
  }
  if (command.length_s == document.clip->length_s) return no_change();
  return with_clip(document, {command.length_s, document.clip->tracks});
}

}  // namespace inkflate
