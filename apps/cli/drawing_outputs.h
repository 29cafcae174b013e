// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/batch.h"
#include "cli/write_drawing.h"

namespace inkflate::cli {

/// Where the drawings made of several inputs go, and pictures of them: one of each for each input, empty where there is none.
struct DrawingOutputs {
  std::vector<std::string> files;
  std::vector<DrawingFormat> formats;  // where there is a file
  std::vector<std::string> pictures;   // PNG
};

/// in      shared: its inputs and what it names as output; picture: what --picture names; extension: of drawings in a folder: ".svg";
///         read: files that are read beside the inputs
/// errors  BadOption: nothing to make, two outputs for standard output, those of plan_files_and_pictures and drawing_format
Result<DrawingOutputs> plan_drawing_outputs(SharedOptions const& shared, std::string const& picture,
                                            std::string const& extension,
                                            std::vector<std::string> const& read = {});

/// Writes what there is to write of the index'th input.
///
/// errors  as write_drawing
std::optional<Error> write_drawing_outputs(Project const& project, DrawingOutputs const& outputs,
                                           int index);

}  // namespace inkflate::cli
