// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace inkflate::cli {

/// Where the outputs of several inputs go.
struct OutputRule {
  std::string option;     // how the user calls it: "-o"
  std::string name;       // a file, FOLDER/ or a folder that exists; empty: no output of this kind
  std::string extension;  // of the files in a folder: ".svg"
};

/// The file to write for each input: the named one, or in a folder the input's name with the rule's extension.
///
/// out     one path for each input; all empty if the rule names nothing
/// errors  BadOption (several inputs and no folder)
Result<std::vector<std::string>> plan_outputs(std::vector<std::string> const& inputs,
                                              OutputRule const& rule);

/// The extension of a path with its dot, in lower case: ".svg".
std::string lower_extension(std::string const& path);

/// Makes the folder, and those above it, of a name that ends with a slash; other names are left alone.
///
/// out     nothing: done; else FileSystem
std::optional<Error> make_folder(std::string const& name);

/// Refuses (BadOption) a file that would be written twice, or that is one of the inputs. Empty paths and "-" for
/// standard output do not count.
std::optional<Error> find_collision(std::vector<std::string> const& inputs,
                                    std::vector<std::string> const& outputs);

/// Where what is made of each input goes, and a picture of it.
struct OutputPaths {
  std::vector<std::string> files;
  std::vector<std::string> pictures;  // PNG; of --picture
};

/// As plan_outputs for both, with what find_collision refuses.
///
/// in      picture: what --picture names; others: further files that will be written
Result<OutputPaths> plan_files_and_pictures(std::vector<std::string> const& inputs,
                                            OutputRule const& files, std::string const& picture,
                                            std::vector<std::string> const& others = {});

}  // namespace inkflate::cli
