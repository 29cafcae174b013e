// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "cli/verb.h"
#include "io/read_document.h"
#include "model/project.h"
#include "pipeline/run_simplify.h"

namespace inkflate::cli {

/// Reads a drawing of any format. Tells on standard error what was left out, unless --quiet. The stage "read" is reported to the progress.
///
/// errors  those of read_file and read_document
Result<ReadDocument> load_document(SharedOptions const& options, std::string const& input,
                                   Progress const& progress);

/// The same, and closes its strokes where it has no closed contours yet.
///
/// errors  those of load_document and run_simplify
Result<Project> load_project(SharedOptions const& options, std::string const& input,
                             RunSimplifyOptions const& simplify, Progress const& progress);

/// What simplify starts from: the scan, or all strokes that are not hidden.
SketchSource sketch_source(ReadDocument const& document);

}  // namespace inkflate::cli
