// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>
#include <utility>

#include "cli/batch.h"
#include "cli/files.h"
#include "cli/load_project.h"
#include "cli/option_values.h"
#include "cli/output_plan.h"
#include "cli/progress_line.h"
#include "cli/simplify_options.h"
#include "cli/verb.h"
#include "cli/write_model.h"
#include "io/json_report.h"
#include "mesh/check_mesh.h"
#include "pipeline/run_inflate.h"
#include "pipeline/stage_clock.h"
#include "render/bake_texture.h"

namespace inkflate::cli {
namespace {

/// The options as the user wrote them.
struct InflateCall {
  SharedOptions shared;
  SimplifyWords words;
  std::string thickness;
  std::string density;
  OpenRuns open = OpenRuns::Joined;
};

/// What to do, checked.
struct InflatePlan {
  RunSimplifyOptions simplify;
  RunInflateOptions inflate;
  std::optional<double> thickness;
  std::vector<std::string> outputs;
  std::vector<ModelFormat> formats;
};

/// A number within a range, where one was given.
Result<std::optional<double>> parse_within(std::string const& option, std::string const& text,
                                           double least, double most) {
  if (text.empty()) return std::optional<double>{};
  auto const number = parse_number(text);
  if (number && *number >= least && *number <= most) return number;
  std::ostringstream range;
  range << option << " wants a number from " << least << " to " << most << ", not " << text;
  return Error{ErrorCode::BadOption, range.str()};
}

std::optional<Error> plan_files(InflateCall const& call, InflatePlan& plan) {
  auto const& shared = call.shared;
  if (shared.output.empty() && !shared.is_json) {
    return Error{ErrorCode::BadOption, "nothing to make: give -o OUTPUT or --json"};
  }
  if (shared.is_json && shared.output == kStandardStream) {
    return Error{ErrorCode::BadOption, "-o - and --json both want standard output; name a file"};
  }
  auto outputs = plan_outputs(shared.inputs, {"-o", shared.output, ".glb"});
  if (!outputs) return outputs.error();
  plan.outputs = std::move(*outputs);
  for (auto const& output : plan.outputs) {
    auto const format = output.empty() ? ModelFormat::Glb : model_format(output);
    if (!format) {
      return Error{ErrorCode::BadOption,
                   "cannot write " + output + ": inflate writes .glb, .obj and .stl"};
    }
    plan.formats.push_back(*format);
  }
  return find_collision(shared.inputs, plan.outputs);
}

Result<InflatePlan> make_plan(InflateCall const& call) {
  InflatePlan plan;
  if (auto const error = plan_files(call, plan)) return *error;
  auto simplify = simplify_options(call.words);
  if (!simplify) return simplify.error();
  plan.simplify = std::move(*simplify);
  auto const thickness = parse_within("--thickness", call.thickness, 0.1, 32);
  if (!thickness) return thickness.error();
  plan.thickness = *thickness;
  auto const density = parse_within("--density", call.density, 0.1, 10);
  if (!density) return density.error();
  plan.inflate.assemble.density = density->value_or(1);
  plan.inflate.assemble.open = call.open;
  return plan;
}

Result<Json> inflate_one(InflateCall const& call, InflatePlan const& plan, int index,
                         ProgressLine& line) {
  StageClock clock;
  Progress const shown = {[&](std::string_view stage) { line.show(stage); }, {}};
  Progress const progress = clock.timed(shown);
  auto project = load_project(call.shared, call.shared.inputs[index], plan.simplify, progress);
  if (!project) return project.error();
  auto& drawing = project->drawing;
  if (plan.thickness) {
    for (auto& layer : drawing.layers) layer.thickness = *plan.thickness;
  }
  auto const model = run_inflate(drawing, plan.inflate, progress);
  if (!model) return model.error();
  auto const& output = plan.outputs[index];
  if (!output.empty()) {
    progress.report("texture");
    auto const texture = bake_texture(drawing, *model);
    progress.report("write");
    if (auto const error = write_model(*model, &texture, plan.formats[index], output)) {
      return *error;
    }
  }
  clock.stop();
  if (!call.shared.is_json) return Json::object();
  ModelFacts const facts = {static_cast<int>(std::ssize(model->layer_names)), "px"};
  return Json::parse(json_report(model->mesh, check_mesh(model->mesh), facts, clock.times()));
}

ExitStatus run_inflate_verb(InflateCall const& call) {
  auto const plan = make_plan(call);
  if (!plan) return refuse(call.shared, plan.error());
  if (auto const error = make_folder(call.shared.output)) return refuse(call.shared, *error);
  ProgressLine line(call.shared.is_quiet ? ProgressLine::Mode::Off : ProgressLine::Mode::Automatic);
  return run_batch(call.shared, [&](int index) { return inflate_one(call, *plan, index, line); });
}

}  // namespace

Verb declare_inflate(CLI::App& program) {
  auto const call = std::make_shared<InflateCall>();
  call->words.parts = Parts::Groups;
  auto& verb = *program.add_subcommand("inflate", "Make a 3D character of a drawing");
  add_shared_options(verb, call->shared);
  verb.add_option("--thickness", call->thickness,
                  "Of all layers: 2 makes limbs round, 4 makes a disc a ball (2)")
      ->type_name("0.1..32");
  verb.add_option("--density", call->density, "Triangles per area, relative to the default (1)")
      ->type_name("0.1..10");
  add_choice<OpenRuns>(
      verb, "--open", call->open,
      {{"joined", OpenRuns::Joined}, {"capped", OpenRuns::Capped}, {"holes", OpenRuns::Holes}},
      "Open ends join other layers, end flat, or stay open where nothing is");
  add_simplify_options(verb, call->words);
  return {&verb, [call] { return run_inflate_verb(*call); }};
}

}  // namespace inkflate::cli
