// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "cli/verb.h"
#include "model/project.h"
#include "pipeline/run_simplify.h"

namespace inkflate::cli {

/// Reads a drawing of any format and closes its strokes where it has no closed contours yet. Tells on standard error what was left
/// out, unless --quiet. The stage "read" is reported to the progress.
///
/// errors  those of read_file, read_document and run_simplify
Result<Project> load_project(SharedOptions const& options, std::string const& input,
                             RunSimplifyOptions const& simplify, Progress const& progress);

}  // namespace inkflate::cli
