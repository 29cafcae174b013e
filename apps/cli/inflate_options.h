// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/simplify_options.h"
#include "pipeline/run_inflate.h"
#include "solidify/solidify.h"

namespace inkflate::cli {

/// What the model looks like.
enum class Wear {
  Drawing,   // the strokes on their layers' colours
  Template,  // the project's picture
  Nothing,   // a plain material
};

/// How a drawing becomes a model, as the user wrote it.
struct InflateWords {
  SimplifyWords simplify;
  std::string thickness;
  std::string density;
  std::vector<std::string> duplicates;
  OpenRuns open = OpenRuns::Joined;
  Wear wear = Wear::Drawing;
  bool is_print = false;
  std::string print_size;
  std::string least;
  bool has_flat_base = false;
};

/// The same, checked.
struct InflateChoices {
  RunSimplifyOptions simplify;
  RunInflateOptions inflate;
  std::optional<double> thickness;  // of all layers; none: each its own
  std::vector<std::string> duplicates;
  Wear wear = Wear::Drawing;
  std::optional<SolidifyOptions> print;  // none: the model as it is
};

void add_inflate_options(CLI::App& verb, InflateWords& words);

/// BadOption names the option and its range.
Result<InflateChoices> inflate_choices(InflateWords const& words);

}  // namespace inkflate::cli
