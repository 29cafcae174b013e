// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "image/grid2.h"
#include "model/clip.h"
#include "model/drawing.h"

namespace inkflate {

/// What a user works on and saves. All else is derived from it.
struct Project {
  Drawing drawing;
  std::optional<Picture> template_picture =
      {};  // to trace and to wear; lies on the canvas as large as fits, centred
  std::vector<Pin> pins = {};
  Clip clip = {};
  int next_id = 1;  // larger than every id that was ever given to a layer or a pin

  friend bool operator==(Project const&, Project const&) = default;
};

}  // namespace inkflate
