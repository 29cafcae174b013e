// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/vec2.h"
#include "model/drawing.h"
#include "model/flat_model.h"

namespace inkflate {

/// Names a pin for as long as its document lives.
enum class PinId : int { None = 0 };

/// A place on the model that a person holds and moves in Animate.
struct Pin {
  PinId id = PinId::None;
  LayerId layer = LayerId::None;
  Side side = Side::Front;
  Vec2 rest;      // where on the layer it holds, canvas px
  Vec2 position;  // where it is now, canvas px

  friend bool operator==(Pin const&, Pin const&) = default;
};

/// Where a pin is at a time.
struct Key {
  double time_s = 0;  // 0 .. the clip's length
  Vec2 position;      // canvas px

  friend bool operator==(Key const&, Key const&) = default;
};

/// The recorded way of one pin.
struct Track {
  PinId pin = PinId::None;
  std::vector<Key> keys;  // times ascend strictly
  double phase_s = 0;     // by how much it runs ahead of the clip

  friend bool operator==(Track const&, Track const&) = default;
};

/// A motion that repeats itself.
struct Clip {
  double length_s = 0;        // >= 0; 0: nothing is recorded
  std::vector<Track> tracks;  // at most one for each pin

  friend bool operator==(Clip const&, Clip const&) = default;
};

}  // namespace inkflate
