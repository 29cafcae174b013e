// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/batch.h"
#include "cli/files.h"
#include "cli/mesh_report.h"
#include "cli/verb.h"

namespace inkflate::cli {
namespace {

struct CheckCall {
  SharedOptions shared;
  bool is_print = false;
};

Result<MeshReport> check_one(CheckCall const& call, std::string const& input) {
  auto const content = read_file(input);
  if (!content) return content.error();
  auto reading = read_mesh(*content);
  if (!reading) return reading.error();
  return report_mesh(std::move(*reading), call.is_print ? MeshPurpose::Print : MeshPurpose::Model);
}

ExitStatus run_check_verb(CheckCall const& call) {
  if (!call.shared.output.empty()) {
    return refuse(call.shared, {ErrorCode::BadOption, "check writes no file: leave out -o"});
  }
  auto worst = ExitStatus::Done;
  auto const job = [&](int index) -> Result<Json> {
    auto const& input = call.shared.inputs[static_cast<std::size_t>(index)];
    auto const report = check_one(call, input);
    if (!report) return report.error();
    // A mesh with faults was read well, so it is no error; the status tells it all the same.
    if (!report->is_ok) worst = ExitStatus::InputRefused;
    if (call.shared.is_json) return mesh_report_json(*report);
    if (!call.shared.is_quiet && !print(mesh_report_text(*report, input))) {
      return Error{ErrorCode::FileSystem, "cannot write to standard output"};
    }
    return Json::object();
  };
  return std::max(run_batch(call.shared, job), worst);
}

}  // namespace

Verb declare_check(CLI::App& program) {
  auto const call = std::make_shared<CheckCall>();
  auto& verb = *program.add_subcommand(
      "check",
      "Tell whether a model's mesh is sound (GLB, OBJ, STL, 3MF); status 3 if it is not.\n"
      "The parts of a layered character pass through each other by design, so several pieces and\n"
      "crossings count only with --print.");
  add_shared_options(verb, call->shared);
  verb.add_flag("--print", call->is_print, "Also demand one piece that nowhere crosses itself");
  return {&verb, [call] { return run_check_verb(*call); }};
}

}  // namespace inkflate::cli
