// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace inkflate {

/// How a long stage tells where it is and asks whether to go on. Both members may be empty.
/// Stages hold no clock: whoever wants timings takes them when a stage is reported.
struct Progress {
  std::function<void(std::string_view stage)> report;
  std::function<bool()> is_cancelled;

  /// Announces that the named stage starts. False: the caller wants to stop; return Cancelled.
  [[nodiscard]] bool enter(std::string_view stage) const {
    if (report) report(stage);
    return !is_cancelled || !is_cancelled();
  }
};

}  // namespace inkflate
