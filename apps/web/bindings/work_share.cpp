// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/work_share.h"

#include <algorithm>
#include <array>

namespace inkflate::web {
namespace {

struct StageShare {
  std::string_view stage;
  double share = 0;  // of the work that lies before it
};

// As the command line tells it by --json, "ms", rounded: means of crab, octopus and dragon in examples/, native; the scan is a
// picture of the crab. A stage that comes for each part of a drawing has the place of its first time.
constexpr std::array kStages = {
    // A scan.
    StageShare{"paper", 0.0},
    StageShare{"ink", 0.3},
    StageShare{"lines", 0.85},
    // Simplify.
    StageShare{"place", 0.0},
    StageShare{"sample", 0.02},
    StageShare{"triangulate", 0.04},
    StageShare{"cut", 0.25},
    StageShare{"holes", 0.4},
    StageShare{"trace", 0.55},
    StageShare{"centre", 0.6},
    StageShare{"fit", 0.7},
    StageShare{"sort", 0.75},
    StageShare{"mouths", 0.8},
    // Simplify on pixels.
    StageShare{"draw strokes on pixels", 0.0},
    StageShare{"cut pixels", 0.01},
    StageShare{"trace pixels", 0.75},
    // Inflate.
    StageShare{"join", 0.0},
    StageShare{"mesh", 0.05},
    StageShare{"stitch", 0.3},
    StageShare{"inflate", 0.35},
    StageShare{"order", 0.45},
    StageShare{"shape", 0.6},
    StageShare{"texture", 0.65},
    // A shell to print.
    StageShare{"lay into the lattice", 0.0},
    StageShare{"scan lines", 0.02},
    StageShare{"thicken", 0.1},
    StageShare{"tell inside from outside", 0.1},
    StageShare{"cut edges", 0.15},
    StageShare{"move nodes", 0.25},
    StageShare{"march", 0.35},
    StageShare{"smooth creases", 0.5},
    StageShare{"write", 0.75},
};

}  // namespace

double WorkShare::enter(std::string_view stage) {
  for (auto const& each : kStages) {
    if (each.stage == stage) share_ = std::max(share_, each.share);
  }
  return share_;
}

}  // namespace inkflate::web
