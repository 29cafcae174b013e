// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/result.h"

namespace inkflate::cli {

/// What the program ends with. In a batch the largest counts.
enum class ExitStatus {
  Done = 0,
  WrongUsage = 2,
  InputRefused = 3,
  CannotReadOrWrite = 4,
  OurOwnFault = 70,  // EX_SOFTWARE of sysexits.h
};

ExitStatus exit_status(ErrorCode code);

/// Turns signals that report a fault of ours into status 70 with one line on standard error.
void end_faults_with_status();

}  // namespace inkflate::cli
