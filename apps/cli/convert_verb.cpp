// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "cli/batch.h"
#include "cli/files.h"
#include "cli/load_project.h"
#include "cli/output_plan.h"
#include "cli/progress_line.h"
#include "cli/verb.h"
#include "cli/write_drawing.h"
#include "ink/trace_scan.h"
#include "pipeline/stage_clock.h"

namespace inkflate::cli {
namespace {

/// The options as the user wrote them.
struct ConvertCall {
  SharedOptions shared;
  bool wants_mask = false;
};

/// What to do, checked.
struct ConvertPlan {
  std::vector<std::string> outputs;
  std::vector<DrawingFormat> formats;
};

Result<ConvertPlan> make_plan(ConvertCall const& call) {
  auto const& shared = call.shared;
  if (shared.output.empty()) return Error{ErrorCode::BadOption, "nothing to make: give -o OUTPUT"};
  if (shared.is_json && shared.output == kStandardStream) {
    return Error{ErrorCode::BadOption, "-o - and --json both want standard output; name a file"};
  }
  ConvertPlan plan;
  auto outputs = plan_outputs(shared.inputs, {"-o", shared.output, ".inkflate"});
  if (!outputs) return outputs.error();
  plan.outputs = std::move(*outputs);
  if (auto const error = find_collision(shared.inputs, plan.outputs)) return *error;
  for (auto const& output : plan.outputs) {
    auto const format = drawing_format(output);
    if (!format) return format.error();
    plan.formats.push_back(*format);
  }
  return plan;
}

/// In the way the sketch means it: by its groups, where it has some.
Result<Drawing> closed(ReadDocument const& document, Progress const& progress) {
  auto const& groups = document.project.drawing.sketch.groups;
  RunSimplifyOptions options;
  if (std::any_of(groups.begin(), groups.end(), is_candidate_layer)) {
    options.simplify.parts = Parts::Groups;
  }
  return run_simplify(sketch_source(document), options, progress);
}

/// What the format needs, and nothing made that the file does not have: a scan becomes strokes, strokes stay as they are.
Result<Project> project_for(ReadDocument& document, bool needs_layers, Progress const& progress) {
  if (needs_layers && !has_layers(document)) {
    auto drawing = closed(document, progress);
    if (!drawing) return drawing.error();
    return Project{std::move(*drawing), std::move(document.project.template_picture)};
  }
  if (!document.scan) return std::move(document.project);
  progress.report("ink");
  auto sketch = trace_scan(*document.scan);
  if (!sketch) return sketch.error();
  return Project{{std::move(*sketch), {}, {}}};
}

Result<Json> convert_one(ConvertCall const& call, ConvertPlan const& plan, int index,
                         ProgressLine& line) {
  StageClock clock;
  Progress const shown = {[&](std::string_view stage) { line.show(stage); }, {}};
  Progress const progress = clock.timed(shown);
  auto document = load_document(call.shared, call.shared.inputs[index], progress);
  if (!document) return document.error();
  auto const format = plan.formats[index];
  bool const is_picture = format == DrawingFormat::MaskPicture && !call.wants_mask;
  bool const needs_layers =
      format == DrawingFormat::MonsterMash || (format == DrawingFormat::MaskPicture && !is_picture);
  auto const project = project_for(*document, needs_layers, progress);
  if (!project) return project.error();
  progress.report("write");
  auto const& output = plan.outputs[index];
  auto const error = is_picture ? save_drawing_picture(project->drawing, output)
                                : write_drawing(*project, format, output);
  if (error) return *error;
  clock.stop();
  Json report = {{"from", file_format_name(document->format)},
                 {"strokes", project->drawing.sketch.strokes.size()},
                 {"layers", project->drawing.layers.size()}};
  for (auto const& [stage, ms] : clock.times()) report["ms"][stage] = ms;
  return report;
}

ExitStatus run_convert_verb(ConvertCall const& call) {
  auto const plan = make_plan(call);
  if (!plan) return refuse(call.shared, plan.error());
  if (auto const error = make_folder(call.shared.output)) return refuse(call.shared, *error);
  ProgressLine line(call.shared.is_quiet ? ProgressLine::Mode::Off : ProgressLine::Mode::Automatic);
  return run_batch(call.shared, [&](int index) { return convert_one(call, *plan, index, line); });
}

}  // namespace

Verb declare_convert(CLI::App& program) {
  auto const call = std::make_shared<ConvertCall>();
  auto& verb = *program.add_subcommand("convert", "Write a drawing or project in another format");
  add_shared_options(verb, call->shared);
  verb.add_flag("--mask", call->wants_mask, "A .png is the silhouette: 255 inside, 0 outside");
  return {&verb, [call] { return run_convert_verb(*call); }};
}

}  // namespace inkflate::cli
