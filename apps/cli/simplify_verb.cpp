// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <utility>

#include "cli/batch.h"
#include "cli/console.h"
#include "cli/drawing_outputs.h"
#include "cli/load_project.h"
#include "cli/output_plan.h"
#include "cli/progress_line.h"
#include "cli/simplify_options.h"
#include "cli/verb.h"
#include "io/json_report.h"
#include "pipeline/stage_clock.h"

namespace inkflate::cli {
namespace {

/// The options as the user wrote them.
struct SimplifyCall {
  SharedOptions shared;
  std::string picture;
  SimplifyWords words;
};

/// What to do, checked.
struct SimplifyPlan {
  RunSimplifyOptions options;
  DrawingOutputs outputs;
};

Result<SimplifyPlan> make_plan(SimplifyCall const& call) {
  SimplifyPlan plan;
  auto outputs = plan_drawing_outputs(call.shared, call.picture, ".svg");
  if (!outputs) return outputs.error();
  plan.outputs = std::move(*outputs);
  auto options = simplify_options(call.words);
  if (!options) return options.error();
  plan.options = std::move(*options);
  return plan;
}

Result<Json> simplify_one(SimplifyCall const& call, SimplifyPlan const& plan, int index,
                          ProgressLine& line) {
  StageClock clock;
  Progress const shown = {[&](std::string_view stage) { line.show(stage); }, {}};
  Progress const progress = clock.timed(shown);
  auto read = load_document(call.shared, call.shared.inputs[index], progress);
  if (!read) return read.error();
  auto drawing = run_simplify(sketch_source(*read), plan.options, progress);
  if (!drawing) return drawing.error();
  auto const& layers = read->project.drawing.layers;
  if (!call.shared.is_quiet && std::any_of(layers.begin(), layers.end(),
                                           [](Layer const& layer) { return layer.is_hidden; })) {
    print_warning(call.shared.inputs[index], "left out what lies in hidden parts");
  }
  Project project = {std::move(*drawing)};
  // Strokes that were moved alone would no longer lie where they were traced.
  if (!call.words.fits) project.template_picture = std::move(read->project.template_picture);
  progress.report("write");
  if (auto const error = write_drawing_outputs(project, plan.outputs, index)) return *error;
  clock.stop();
  if (!call.shared.is_json) return Json::object();
  return Json::parse(json_report(project.drawing, clock.times()));
}

ExitStatus run_simplify_verb(SimplifyCall const& call) {
  auto const plan = make_plan(call);
  if (!plan) return refuse(call.shared, plan.error());
  for (auto const& folder : {call.shared.output, call.picture}) {
    if (auto const error = make_folder(folder)) return refuse(call.shared, *error);
  }
  ProgressLine line(call.shared.is_quiet ? ProgressLine::Mode::Off : ProgressLine::Mode::Automatic);
  return run_batch(call.shared, [&](int index) { return simplify_one(call, *plan, index, line); });
}

}  // namespace

Verb declare_simplify(CLI::App& program) {
  auto const call = std::make_shared<SimplifyCall>();
  auto& verb = *program.add_subcommand("simplify", "Close rough strokes into clean contours");
  add_shared_options(verb, call->shared);
  verb.add_option("--picture", call->picture, "Also write a picture to look at (PNG), or FOLDER/")
      ->type_name("FILE");
  add_simplify_options(verb, call->words);
  return {&verb, [call] { return run_simplify_verb(*call); }};
}

}  // namespace inkflate::cli
