// SPDX-License-Identifier: Apache-2.0
#include "cli/batch.h"

#include <algorithm>
#include <new>
#include <utility>

namespace inkflate::cli {
namespace {

// The one place where a failure to get memory ends; nothing else in here throws for an expected reason.
Result<Json> run_guarded(InputJob const& job, int index) {
  try {
    return job(index);
  } catch (std::bad_alloc const&) {
    return Error{ErrorCode::TooLarge, "not enough memory"};
  }
}

ExitStatus print_report(Json const& report, ExitStatus worst) {
  if (print(to_text(report))) return worst;
  print_error("", {ErrorCode::FileSystem, "cannot write to standard output"});
  return std::max(worst, ExitStatus::CannotReadOrWrite);
}

}  // namespace

ExitStatus run_batch(SharedOptions const& options, InputJob const& job) {
  auto worst = ExitStatus::Done;
  Json files = Json::array();
  int const count = static_cast<int>(std::ssize(options.inputs));
  for (int i = 0; i < count; ++i) {
    auto const& input = options.inputs[i];
    auto outcome = run_guarded(job, i);
    Json report = {{"input", input}};
    if (outcome) {
      report.update(*outcome);
    } else {
      print_error(input, outcome.error());
      report.update(error_json(outcome.error()));
      worst = std::max(worst, exit_status(outcome.error().code));
    }
    files.push_back(std::move(report));
  }
  if (!options.is_json) return worst;
  return print_report(count == 1 ? files[0] : Json{{"files", files}}, worst);
}

ExitStatus refuse(SharedOptions const& options, Error const& error) {
  print_error("", error);
  auto const status = exit_status(error.code);
  return options.is_json ? print_report(error_json(error), status) : status;
}

}  // namespace inkflate::cli
