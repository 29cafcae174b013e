// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>
#include <sstream>

#include "cli/console.h"
#include "cli/files.h"
#include "cli/verb.h"

namespace inkflate::cli {
namespace {

constexpr char const* kVersion = "inkflate " INKFLATE_VERSION;

bool asks_for_json(std::vector<std::string> const& words) {
  auto const end = std::find(words.begin(), words.end(), "--");
  return std::find(words.begin(), end, "--json") != end;
}

// --help and --version arrive as failures too.
ExitStatus answer_failed_parse(CLI::App const& program, CLI::ParseError const& failure,
                               std::vector<std::string> const& words) {
  if (failure.get_exit_code() == 0) {
    std::ostringstream text;
    program.exit(failure, text, text);
    return print(text.str()) ? ExitStatus::Done : ExitStatus::CannotReadOrWrite;
  }
  Error const error = {ErrorCode::BadOption, std::string(failure.what()) + " (see --help)"};
  print_error("", error);
  if (asks_for_json(words)) print(to_text(error_json(error)));
  return ExitStatus::WrongUsage;
}

ExitStatus run_verb(std::vector<Verb> const& verbs) {
  for (auto const& verb : verbs) {
    if (verb.declared->parsed()) return verb.run();
  }
  CHECK(false, "the parser lets nothing pass without a verb");
}

}  // namespace

void add_shared_options(CLI::App& verb, SharedOptions& options) {
  verb.add_option("input", options.inputs, "Files to read; - is standard input")
      ->required()
      ->type_name("INPUT");
  verb.add_option("-o,--output", options.output, "File to write, or FOLDER/; - is standard output")
      ->type_name("OUTPUT");
  verb.add_flag("--json", options.is_json, "Print one JSON object with what was done");
  verb.add_flag("--quiet", options.is_quiet, "No progress and no warnings");
  verb.set_version_flag("--version", kVersion, "Print the version");
}

ExitStatus run_command_line(std::vector<std::string> const& words) {
  CLI::App program{"From rough sketches to clean closed shapes", "inkflate"};
  program.set_version_flag("--version", kVersion, "Print the version");
  program.require_subcommand(1);
  program.failure_message(CLI::FailureMessage::simple);
  std::vector<Verb> const verbs = {
      declare_simplify(program), declare_deform(program), declare_inflate(program),
      declare_render(program),   declare_check(program),  declare_convert(program),
      declare_info(program),     declare_hash(program),   declare_replay(program)};
  try {
    program.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 wants it so
  } catch (CLI::ParseError const& failure) {
    return answer_failed_parse(program, failure, words);
  }
  return run_verb(verbs);
}

}  // namespace inkflate::cli
