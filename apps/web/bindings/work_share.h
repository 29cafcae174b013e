// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace inkflate::web {

/// How far a piece of long work has come, by the stages that it enters.
class WorkShare {
 public:
  /// The work that is about to begin is another one.
  void start() { share_ = 0; }

  /// 0 .. 1, never less than before: stages come again for each part of a drawing. How long they take is an estimate.
  double enter(std::string_view stage);

 private:
  double share_ = 0;
};

}  // namespace inkflate::web
