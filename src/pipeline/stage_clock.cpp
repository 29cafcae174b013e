// SPDX-License-Identifier: Apache-2.0
#include "pipeline/stage_clock.h"

#include <algorithm>
#include <string>

namespace inkflate {

Progress StageClock::timed(Progress const& progress) {
  return {[this, &progress](std::string_view stage) {
            start(stage);
            if (progress.report) progress.report(stage);
          },
          progress.is_cancelled};
}

void StageClock::start(std::string_view stage) {
  stop();
  auto const found = std::find_if(times_.begin(), times_.end(),
                                  [&](StageTime const& time) { return time.stage == stage; });
  running_ = static_cast<int>(found - times_.begin());
  if (found == times_.end()) times_.push_back({std::string(stage), 0});
  started_ = std::chrono::steady_clock::now();
}

void StageClock::stop() {
  if (running_ < 0) return;
  std::chrono::duration<double, std::milli> const passed =
      std::chrono::steady_clock::now() - started_;
  times_[running_].ms += passed.count();
  running_ = -1;
}

}  // namespace inkflate
