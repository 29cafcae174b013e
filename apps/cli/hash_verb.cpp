// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>

#include "cli/batch.h"
#include "cli/load_project.h"
#include "cli/verb.h"
#include "io/document_hash.h"
#include "io/numbers.h"

namespace inkflate::cli {
namespace {

Result<Json> hash_one(SharedOptions const& options, int index) {
  auto const& input = options.inputs[static_cast<std::size_t>(index)];
  auto document = load_document(options, input, {});
  if (!document) return document.error();
  // A scan is what there is to trace, and nothing traced yet.
  if (document->scan) document->project.template_picture = std::move(document->scan);
  auto const hash = hex_digits(document_hash(document->project));
  if (options.is_json) return Json{{"hash", hash}};
  if (print(hash + "  " + one_line(input) + "\n")) return Json::object();
  return Error{ErrorCode::FileSystem, "cannot write to standard output"};
}

ExitStatus run_hash_verb(SharedOptions const& options) {
  if (!options.output.empty()) {
    return refuse(options, {ErrorCode::BadOption, "hash writes no file; leave out -o"});
  }
  return run_batch(options, [&](int index) { return hash_one(options, index); });
}

}  // namespace

Verb declare_hash(CLI::App& program) {
  auto const options = std::make_shared<SharedOptions>();
  auto& verb = *program.add_subcommand(
      "hash",
      "Print a number for what each file holds: the same for the same drawing,\n"
      "whatever the format and the machine");
  add_shared_options(verb, *options);
  return {&verb, [options] { return run_hash_verb(*options); }};
}

}  // namespace inkflate::cli
