// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace inkflate {

/// How long a named stage took, for reports.
struct StageTime {
  std::string stage;
  double ms = 0;  // >= 0

  friend bool operator==(StageTime const&, StageTime const&) = default;
};

}  // namespace inkflate
