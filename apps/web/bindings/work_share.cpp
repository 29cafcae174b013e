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

// What a character of five parts takes: bench/stage_times, benchmarks of solidify.
constexpr std::array kStages = {
    // A scan.
    StageShare{"paper", 0.0},
    StageShare{"ink", 0.3},
    StageShare{"lines", 0.6},
    // Simplify.
    StageShare{"place", 0.0},
    StageShare{"sort", 0.05},
    StageShare{"sample", 0.1},
    StageShare{"triangulate", 0.15},
    StageShare{"cut", 0.3},
    StageShare{"holes", 0.5},
    StageShare{"trace", 0.55},
    StageShare{"draw strokes on pixels", 0.1},
    StageShare{"cut pixels", 0.2},
    StageShare{"trace pixels", 0.55},
    StageShare{"mouths", 0.6},
    StageShare{"centre", 0.65},
    StageShare{"fit", 0.8},
    // Inflate.
    StageShare{"join", 0.0},
    StageShare{"mesh", 0.05},
    StageShare{"stitch", 0.25},
    StageShare{"inflate", 0.3},
    StageShare{"order", 0.55},
    StageShare{"shape", 0.6},
    StageShare{"texture", 0.85},
    // A shell to print.
    StageShare{"lay into the lattice", 0.0},
    StageShare{"scan lines", 0.1},
    StageShare{"thicken", 0.3},
    StageShare{"tell inside from outside", 0.4},
    StageShare{"cut edges", 0.5},
    StageShare{"move nodes", 0.65},
    StageShare{"march", 0.75},
    StageShare{"write", 0.95},
};

}  // namespace

double WorkShare::enter(std::string_view stage) {
  for (auto const& each : kStages) {
    if (each.stage == stage) share_ = std::max(share_, each.share);
  }
  return share_;
}

}  // namespace inkflate::web
