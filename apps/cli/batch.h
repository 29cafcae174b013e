// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "cli/console.h"
#include "cli/verb.h"

namespace inkflate::cli {

/// What a verb does with one of its inputs: gives the report, or why there is none.
using InputJob = std::function<Result<Json>(int index)>;

/// Runs the job for every input, also after one that failed; tells each failure on standard error. With --json one
/// object goes to standard output: the report itself for a single input, {"files": [...]} for several.
///
/// out     the worst status of all inputs
ExitStatus run_batch(SharedOptions const& options, InputJob const& job);

/// Tells a failure that concerns the whole call, in the same way.
ExitStatus refuse(SharedOptions const& options, Error const& error);

}  // namespace inkflate::cli
