// SPDX-License-Identifier: Apache-2.0
#include "cli/load_project.h"

#include <utility>

#include "cli/console.h"
#include "cli/files.h"

namespace inkflate::cli {

Result<ReadDocument> load_document(SharedOptions const& options, std::string const& input,
                                   Progress const& progress) {
  if (!progress.enter("read")) return Error{ErrorCode::Cancelled, "stopped on request"};
  auto const content = read_file(input);
  if (!content) return content.error();
  auto document = read_document(*content);
  if (!document) return document.error();
  if (!options.is_quiet) {
    for (auto const& warning : document->warnings) print_warning(input, warning);
  }
  return document;
}

Result<Project> load_project(SharedOptions const& options, std::string const& input,
                             RunSimplifyOptions const& simplify, Progress const& progress) {
  auto document = load_document(options, input, progress);
  if (!document) return document.error();
  if (has_layers(*document)) return std::move(document->project);
  auto drawing = run_simplify(sketch_source(*document), simplify, progress);
  if (!drawing) return drawing.error();
  document->project.drawing = std::move(*drawing);
  return std::move(document->project);
}

SketchSource sketch_source(ReadDocument const& document) {
  if (document.scan) return *document.scan;
  return shown_sketch(document.project.drawing);
}

}  // namespace inkflate::cli
