// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/exit_status.h"

namespace CLI {
class App;
}  // namespace CLI

namespace inkflate::cli {

/// What every verb takes.
struct SharedOptions {
  std::vector<std::string> inputs;  // at least one; "-": standard input
  std::string output;               // "-": standard output; empty: none
  bool is_json = false;             // one JSON object on standard output, and nothing else there
  bool is_quiet = false;            // no progress and no warnings
};

void add_shared_options(CLI::App& verb, SharedOptions& options);

/// A word of the command line that does something. The function belongs to the declared options and runs once they
/// are parsed.
struct Verb {
  CLI::App* declared = nullptr;
  std::function<ExitStatus()> run;
};

/// One for each verb, in NAME_verb.cpp.
Verb declare_simplify(CLI::App& program);
Verb declare_deform(CLI::App& program);
Verb declare_inflate(CLI::App& program);
Verb declare_render(CLI::App& program);
Verb declare_convert(CLI::App& program);
Verb declare_info(CLI::App& program);
Verb declare_check(CLI::App& program);
Verb declare_hash(CLI::App& program);
Verb declare_replay(CLI::App& program);

}  // namespace inkflate::cli
