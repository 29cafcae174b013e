// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/stage_time.h"

namespace inkflate {

/// Takes the time of stages as they report themselves. A stage that runs several times is one entry.
class StageClock {
 public:
  /// Progress that times each reported stage and passes everything on to the caller's own. The clock and the
  /// caller's progress have to outlive it.
  Progress timed(Progress const& progress);

  void start(std::string_view stage);
  void stop();

  /// Stages in the order in which they first ran.
  std::vector<StageTime> const& times() const { return times_; }

 private:
  std::vector<StageTime> times_;
  int running_ = -1;  // index into times_; -1: none
  std::chrono::steady_clock::time_point started_;
};

}  // namespace inkflate
