// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "cli/batch.h"
#include "cli/console.h"
#include "cli/files.h"
#include "cli/inflate_options.h"
#include "cli/load_project.h"
#include "cli/output_plan.h"
#include "cli/progress_line.h"
#include "cli/verb.h"
#include "cli/write_drawing.h"
#include "cli/write_model.h"
#include "io/json_report.h"
#include "mesh/check_mesh.h"
#include "pipeline/stage_clock.h"
#include "render/bake_texture.h"

namespace inkflate::cli {
namespace {

/// The options as the user wrote them.
struct InflateCall {
  SharedOptions shared;
  InflateWords words;
};

/// A model, or the project that it is made from.
using OutputFormat = std::variant<ModelFormat, DrawingFormat>;

/// What to do, checked.
struct InflatePlan {
  InflateChoices choices;
  std::vector<std::string> outputs;
  std::vector<OutputFormat> formats;
};

Result<OutputFormat> output_format(std::string const& path, bool is_print) {
  auto const extension = lower_extension(path);
  auto const model = path.empty() ? ModelFormat::Glb : model_format(path);
  bool const is_printable = model == ModelFormat::Stl || model == ModelFormat::ThreeMf;
  if (is_print && !path.empty() && !is_printable) {
    return Error{ErrorCode::BadOption, "cannot print " + path + ": --print writes .stl and .3mf"};
  }
  if (model) return OutputFormat{*model};
  if (extension == ".inkflate") return OutputFormat{DrawingFormat::Inkflate};
  if (extension == ".zip") return OutputFormat{DrawingFormat::MonsterMash};
  return Error{ErrorCode::BadOption, "cannot write " + path +
                                         ": inflate writes .glb, .obj, .stl, .3mf, .inkflate and "
                                         ".zip (Monster Mash)"};
}

std::optional<Error> plan_files(InflateCall const& call, InflatePlan& plan) {
  auto const& shared = call.shared;
  if (shared.output.empty() && !shared.is_json) {
    return Error{ErrorCode::BadOption, "nothing to make: give -o OUTPUT or --json"};
  }
  if (shared.is_json && shared.output == kStandardStream) {
    return Error{ErrorCode::BadOption, "-o - and --json both want standard output; name a file"};
  }
  char const* const extension = call.words.is_print ? ".stl" : ".glb";
  auto outputs = plan_outputs(shared.inputs, {"-o", shared.output, extension});
  if (!outputs) return outputs.error();
  plan.outputs = std::move(*outputs);
  for (auto const& output : plan.outputs) {
    auto const format = output_format(output, call.words.is_print);
    if (!format) return format.error();
    plan.formats.push_back(*format);
  }
  return find_collision(shared.inputs, plan.outputs);
}

Result<InflatePlan> make_plan(InflateCall const& call) {
  InflatePlan plan;
  if (auto const error = plan_files(call, plan)) return *error;
  auto choices = inflate_choices(call.words);
  if (!choices) return choices.error();
  plan.choices = std::move(*choices);
  return plan;
}

/// The project as it is to be inflated.
std::optional<Error> prepare(Project& project, InflateChoices const& choices) {
  auto& layers = project.drawing.layers;
  for (auto const& name : choices.duplicates) {
    auto const found = std::find_if(layers.begin(), layers.end(),
                                    [&](Layer const& layer) { return layer.name == name; });
    if (found == layers.end()) {
      return Error{ErrorCode::BadOption, "--duplicate: there is no part \"" + name + "\""};
    }
    duplicate_behind(project.drawing, static_cast<int>(found - layers.begin()));
  }
  if (choices.thickness) {
    for (auto& layer : layers) layer.thickness = *choices.thickness;
  }
  if (choices.wear == Wear::Template && !project.template_picture) {
    return Error{ErrorCode::BadOption, "--wear template: the project has no template picture"};
  }
  return std::nullopt;
}

/// What became of a project.
struct Inflated {
  Project const& project;
  Drawing const& drawing;  // what is shown of it: the model is made of that
  RestModel const& model;
};

std::optional<Error> write_worn(Inflated const& made, Wear wear, ModelFormat format,
                                std::string const& path, Progress const& progress) {
  bool const has_texture = format == ModelFormat::Glb || format == ModelFormat::Obj;
  Texture texture;
  if (has_texture && wear != Wear::Nothing) {
    progress.report("texture");
    texture = wear == Wear::Drawing ? bake_texture(made.drawing, made.model)
                                    : wear_picture(*made.project.template_picture, made.model);
  }
  progress.report("write");
  return write_model(made.model, texture.corners.empty() ? nullptr : &texture, made.drawing, format,
                     path);
}

Json report_of(TriMesh const& mesh, Drawing const& drawing, std::string const& unit,
               StageClock& clock) {
  clock.stop();
  ModelFacts const facts = {static_cast<int>(std::ssize(drawing.layers)), unit};
  return Json::parse(json_report(mesh, check_mesh(mesh), facts, clock.times()));
}

/// One job while it runs.
struct InflateJob {
  InflateChoices const& choices;
  OutputFormat format;
  std::string const& path;
  StageClock& clock;
  Progress const& progress;
  SharedOptions const& shared;
  std::string const& input;
};

Result<Json> finish_print(InflateJob const& job, Inflated const& made) {
  auto const shell = solidify(made.model.mesh, *job.choices.print, job.progress);
  if (!shell) return shell.error();
  job.progress.report("write");
  if (!job.path.empty()) {
    auto const format = std::get<ModelFormat>(job.format);
    if (auto error = write_print(*shell, made.drawing, format, job.path)) return *error;
  }
  int const pieces = check_mesh(*shell).shells;
  if (pieces > 1 && !job.shared.is_quiet) {
    print_warning(job.input, "the print has " + std::to_string(pieces) +
                                 " pieces that do not touch; draw parts so that they overlap");
  }
  return job.shared.is_json ? report_of(*shell, made.drawing, "mm", job.clock) : Json::object();
}

Result<Json> finish_model(InflateJob const& job, Inflated const& made) {
  std::optional<Error> error;
  if (auto const* format = std::get_if<DrawingFormat>(&job.format)) {
    job.progress.report("write");
    error = write_drawing(made.project, *format, job.path);
  } else if (!job.path.empty()) {
    error = write_worn(made, job.choices.wear, std::get<ModelFormat>(job.format), job.path,
                       job.progress);
  }
  if (error) return *error;
  return job.shared.is_json ? report_of(made.model.mesh, made.drawing, "px", job.clock)
                            : Json::object();
}

Result<Json> inflate_one(InflateCall const& call, InflatePlan const& plan, int index,
                         ProgressLine& line) {
  auto const& choices = plan.choices;
  StageClock clock;
  Progress const told = {[&](std::string_view stage) { line.show(stage); }, {}};
  Progress const progress = clock.timed(told);
  auto project = load_project(call.shared, call.shared.inputs[index], choices.simplify, progress);
  if (!project) return project.error();
  if (auto const error = prepare(*project, choices)) return *error;
  auto const drawing = shown(project->drawing);
  auto const model = run_inflate(drawing, choices.inflate, progress);
  if (!model) return model.error();
  InflateJob const job = {choices,  plan.formats[index], plan.outputs[index],      clock,
                          progress, call.shared,         call.shared.inputs[index]};
  Inflated const made = {*project, drawing, *model};
  return choices.print ? finish_print(job, made) : finish_model(job, made);
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
  call->words.simplify.parts = Parts::Groups;
  auto& verb = *program.add_subcommand("inflate", "Make a 3D character of a drawing");
  add_shared_options(verb, call->shared);
  add_inflate_options(verb, call->words);
  return {&verb, [call] { return run_inflate_verb(*call); }};
}

}  // namespace inkflate::cli
