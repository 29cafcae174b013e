// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <utility>
#include <variant>

#include "cli/batch.h"
#include "cli/files.h"
#include "cli/option_values.h"
#include "cli/output_plan.h"
#include "cli/replay.h"
#include "cli/verb.h"
#include "cli/write_drawing.h"
#include "cli/write_model.h"
#include "editor/model_cache.h"
#include "pipeline/stage_clock.h"

namespace inkflate::cli {
namespace {

/// The options as the user wrote them.
struct ReplayCall {
  SharedOptions shared;
  std::string picture;
  std::string size;
  std::string files;
  std::string steps;
  std::string journal;
  std::string recover;
  int pace_ms = 0;
  bool has_hash = false;
  bool acknowledges = false;
};

/// What the window shows.
struct WindowPicture {};

using OutputFormat = std::variant<WindowPicture, ModelFormat, DrawingFormat>;

/// What to do, checked.
struct ReplayPlan {
  std::optional<PictureSize> size;
  std::vector<std::string> outputs;
  std::vector<OutputFormat> formats;
  std::vector<std::string> pictures;
};

Result<OutputFormat> output_format(std::string const& path) {
  auto const extension = lower_extension(path);
  if (path.empty() || extension == ".png") return OutputFormat{WindowPicture{}};
  if (auto const model = model_format(path); model && path != kStandardStream) {
    return OutputFormat{*model};
  }
  auto const drawing = drawing_format(path);
  if (drawing) return OutputFormat{*drawing};
  return Error{ErrorCode::BadOption, "cannot write " + path +
                                         ": replay writes .inkflate, .svg, .zip, .png, .glb, "
                                         ".obj, .stl and .3mf"};
}

std::optional<Error> check_single(ReplayCall const& call) {
  bool const has_own_files =
      !call.files.empty() || !call.steps.empty() || !call.journal.empty() || !call.recover.empty();
  if (has_own_files && call.shared.inputs.size() > 1) {
    return Error{ErrorCode::BadOption,
                 "--files, --steps, --journal and --recover want a single recording"};
  }
  bool const wants_stream = call.shared.output == kStandardStream;
  bool const tells = call.shared.is_json || call.has_hash || call.acknowledges;
  if (wants_stream && tells) {
    return Error{ErrorCode::BadOption, "-o - wants standard output for itself; name a file"};
  }
  if (call.shared.is_json && (call.has_hash || call.acknowledges)) {
    return Error{ErrorCode::BadOption, "--json wants standard output for itself"};
  }
  return std::nullopt;
}

Result<ReplayPlan> make_plan(ReplayCall const& call) {
  if (auto const error = check_single(call)) return *error;
  ReplayPlan plan;
  if (!call.size.empty()) {
    auto const size = parse_picture_size("--size", call.size);
    if (!size) return size.error();
    plan.size = *size;
  }
  auto paths = plan_files_and_pictures(call.shared.inputs, {"-o", call.shared.output, ".inkflate"},
                                       call.picture, {call.journal});
  if (!paths) return paths.error();
  plan.outputs = std::move(paths->files);
  plan.pictures = std::move(paths->pictures);
  for (auto const& output : plan.outputs) {
    auto const format = output_format(output);
    if (!format) return format.error();
    plan.formats.push_back(*format);
  }
  return plan;
}

std::optional<Error> write_shown_model(Document const& document, ModelFormat format,
                                       std::string const& path) {
  ModelCache cache;
  auto const made = cache.make(document, {});
  if (!made) return made.error();
  auto const scene = cache.scene({}, Shading::Textured);
  return write_model(*scene->model, scene->texture.get(), shown_drawing(document), format, path);
}

std::optional<Error> write_output(Replay& replay, OutputFormat const& format,
                                  std::string const& path) {
  auto const& document = replay.engine().history().document();
  if (auto const* const model = std::get_if<ModelFormat>(&format)) {
    return write_shown_model(document, *model, path);
  }
  if (auto const* const drawing = std::get_if<DrawingFormat>(&format)) {
    return write_drawing(to_project(document), *drawing, path);
  }
  return replay.write_picture(path);
}

std::string folder_of(std::string const& input) {
  return input == kStandardStream ? "" : std::filesystem::path(input).parent_path().string();
}

Json report_of(Replay& replay, StageClock& clock) {
  clock.stop();
  auto const& history = replay.engine().history();
  Json report = {{"events", replay.steps()},
                 {"entries", history.position()},
                 {"layers", history.document().layers->size()},
                 {"hash", replay.hash()},
                 {"messages", replay.messages()}};
  for (auto const& stage : clock.times()) report["ms"][stage.stage] = stage.ms;
  return report;
}

std::optional<Error> play(ReplayCall const& call, std::string const& input, Replay& replay) {
  auto const content = read_file(input);
  if (!content) return content.error();
  auto const events =
      read_events({reinterpret_cast<char const*>(content->data()), content->size()});
  if (!events) return events.error();
  if (!call.recover.empty()) {
    auto const journal = read_file(call.recover);
    if (!journal) return Error{journal.error().code, call.recover + ": " + journal.error().message};
    if (auto error = replay.recover(*journal)) return error;
  }
  return replay.run(*events);
}

Result<Json> replay_one(ReplayCall const& call, ReplayPlan const& plan, int index) {
  StageClock clock;
  Progress const silent;
  Progress const progress = clock.timed(silent);
  auto const& input = call.shared.inputs[index];
  ReplayOptions options = {folder_of(input), call.files, call.steps};
  if (!call.journal.empty()) options.journal.emplace(call.journal);
  options.pace_ms = call.pace_ms;
  options.acknowledges = call.acknowledges;
  options.prints_hashes = !call.shared.is_json;
  options.shows_messages = !call.shared.is_quiet;
  options.input_name = input;
  Replay replay(std::move(options));
  progress.report("replay");
  if (plan.size) {
    ResizeEvent const size = {static_cast<double>(plan.size->width),
                              static_cast<double>(plan.size->height)};
    if (auto const error = replay.resize(size)) return *error;
  }
  if (auto const error = play(call, input, replay)) return *error;
  progress.report("write");
  if (auto const& output = plan.outputs[index]; !output.empty()) {
    if (auto const error = write_output(replay, plan.formats[index], output)) return *error;
  }
  if (auto const& picture = plan.pictures[index]; !picture.empty()) {
    if (auto const error = replay.write_picture(picture)) return *error;
  }
  if (call.has_hash) print(replay.hash() + "\n");
  return call.shared.is_json ? report_of(replay, clock) : Json::object();
}

ExitStatus run_replay_verb(ReplayCall const& call) {
  auto const plan = make_plan(call);
  if (!plan) return refuse(call.shared, plan.error());
  auto const as_folder = [](std::string const& name) { return name.empty() ? "" : name + "/"; };
  for (auto const& folder :
       {call.shared.output, call.picture, as_folder(call.files), as_folder(call.steps)}) {
    if (auto const error = make_folder(folder)) return refuse(call.shared, *error);
  }
  return run_batch(call.shared, [&](int index) { return replay_one(call, *plan, index); });
}

}  // namespace

Verb declare_replay(CLI::App& program) {
  auto const call = std::make_shared<ReplayCall>();
  auto& verb = *program.add_subcommand("replay", "Run recordings of what was done in the editor");
  add_shared_options(verb, call->shared);
  verb.add_option("--picture", call->picture, "Write what the window shows (PNG), or FOLDER/")
      ->type_name("FILE");
  verb.add_option("--size", call->size, "Of the window at the start, px (1000)")
      ->type_name("N|WxH");
  verb.add_flag("--hash", call->has_hash, "Print the document's hash at the end");
  verb.add_option("--files", call->files, "Where the recording may save files and pictures")
      ->type_name("FOLDER/");
  verb.add_option("--steps", call->steps, "Write project, picture and hash after each change")
      ->type_name("FOLDER/");
  verb.add_option("--journal", call->journal, "Keep a journal from which work can be recovered")
      ->type_name("FILE");
  verb.add_option("--recover", call->recover, "Go on from a journal")->type_name("FILE");
  verb.add_option("--pace", call->pace_ms, "Wait before each step, ms (0)")
      ->check(CLI::Range(0, 10'000))
      ->type_name("MS");
  verb.add_flag("--acknowledge", call->acknowledges,
                "Print for each step: its number, lines in the journal, hash");
  return {&verb, [call] { return run_replay_verb(*call); }};
}

}  // namespace inkflate::cli
