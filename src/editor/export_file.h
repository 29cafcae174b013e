// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "document/document.h"
#include "editor/engine.h"
#include "editor/model_cache.h"
#include "editor/view.h"

namespace inkflate {

/// What is exported, and as what.
struct ExportRequest {
  Document const& document;
  View const& view;
  std::string name;       // of the files, without extension
  std::string extension;  // without its dot: inkflate svg png zip glb obj stl 3mf
};

/// What is seen as files. A PNG shows the drawing in Draw and the model in the other modes, on a clear ground; STL and 3MF hold one
/// watertight shell to print. The model is made when it is not current.
///
/// errors  BadOption (another extension), NothingThere, TooLarge, Cancelled; those of run_inflate and solidify
Result<std::vector<FileOut>> export_file(ExportRequest const& request, ModelCache& cache,
                                         Progress const& progress);

}  // namespace inkflate
