// SPDX-License-Identifier: Apache-2.0
#include "document/edit_pins.h"

#include <memory>
#include <utility>

namespace inkflate {

Document without_pins(Document document, std::set<PinId> const& gone) {
  if (gone.empty()) return document;
  std::vector<Pin> pins;
  for (auto const& pin : *document.pins) {
    if (gone.count(pin.id) == 0) pins.push_back(pin);
  }
  Clip clip = {document.clip->length_s, {}};
  for (auto const& track : document.clip->tracks) {
    if (gone.count(track.pin) == 0) clip.tracks.push_back(track);
  }
  bool const is_clip_changed = clip.tracks.size() != document.clip->tracks.size();
  document.pins = std::make_shared<std::vector<Pin> const>(std::move(pins));
  if (is_clip_changed) document.clip = std::make_shared<Clip const>(std::move(clip));
  return document;
}

}  // namespace inkflate
