// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <utility>

#include "cli/batch.h"
#include "cli/files.h"
#include "cli/option_values.h"
#include "cli/output_plan.h"
#include "cli/progress_line.h"
#include "cli/read_sketch.h"
#include "cli/verb.h"
#include "cli/write_drawing.h"
#include "io/json_report.h"
#include "pipeline/stage_clock.h"

namespace inkflate::cli {
namespace {

/// The options as the user wrote them.
struct SimplifyCall {
  SharedOptions shared;
  std::string picture;
  std::string gap = "auto";
  std::vector<std::string> outside;
  std::vector<std::string> inside;
  std::string smooth;
  std::string size;
  bool fits = false;
  SimplifyMethod method = SimplifyMethod::Cut;
  Holes holes = Holes::Keep;
  Parts parts = Parts::All;
};

/// What to do, checked.
struct SimplifyPlan {
  RunSimplifyOptions options;
  std::vector<std::string> outputs;
  std::vector<DrawingFormat> formats;  // where there is an output
  std::vector<std::string> pictures;
};

Error bad_value(std::string const& option, std::string const& range, std::string const& text) {
  return {ErrorCode::BadOption, option + " wants " + range + ", not " + text};
}

Result<RunSimplifyOptions> run_options(SimplifyCall const& call) {
  RunSimplifyOptions options;
  options.simplify.method = call.method;
  options.simplify.holes = call.holes;
  options.simplify.parts = call.parts;
  options.place.mode = call.fits ? PlaceMode::FitStrokes : PlaceMode::WholeCanvas;
  if (call.gap != "auto") {
    auto const gap_px = parse_number(call.gap);
    if (!gap_px || *gap_px <= 0) return bad_value("--gap", "auto or a length over 0", call.gap);
    options.simplify.gap_px = gap_px;
  }
  if (!call.smooth.empty()) {
    auto const smooth = parse_number(call.smooth);
    bool const is_legal = smooth && *smooth >= 0 && *smooth <= 1;
    if (!is_legal) return bad_value("--smooth", "a number from 0 to 1", call.smooth);
    options.simplify.smooth = *smooth;
  }
  if (!call.size.empty()) {
    auto const size_px = parse_number(call.size);
    bool const is_legal = size_px && *size_px >= 1 && *size_px <= PlaceOptions::kMaxSizePx;
    if (!is_legal) return bad_value("--size", "1 to 16384 px", call.size);
    options.place.size_px = size_px;
  }
  auto const outside = parse_points("--outside", call.outside);
  if (!outside) return outside.error();
  auto const inside = parse_points("--inside", call.inside);
  if (!inside) return inside.error();
  options.simplify.outside = *outside;
  options.simplify.inside = *inside;
  return options;
}

std::optional<Error> check_streams(SimplifyCall const& call) {
  auto const& shared = call.shared;
  if (shared.output.empty() && call.picture.empty() && !shared.is_json) {
    return Error{ErrorCode::BadOption, "nothing to make: give -o OUTPUT, --picture FILE or --json"};
  }
  if (call.picture == kStandardStream) {
    return Error{ErrorCode::BadOption, "--picture needs a file name"};
  }
  if (shared.is_json && shared.output == kStandardStream) {
    return Error{ErrorCode::BadOption, "-o - and --json both want standard output; name a file"};
  }
  return std::nullopt;
}

Result<SimplifyPlan> make_plan(SimplifyCall const& call) {
  if (auto const error = check_streams(call)) return *error;
  SimplifyPlan plan;
  auto options = run_options(call);
  if (!options) return options.error();
  plan.options = std::move(*options);
  auto const& inputs = call.shared.inputs;
  auto outputs = plan_outputs(inputs, {"-o", call.shared.output, ".svg"});
  if (!outputs) return outputs.error();
  auto pictures = plan_outputs(inputs, {"--picture", call.picture, ".png"});
  if (!pictures) return pictures.error();
  plan.outputs = std::move(*outputs);
  plan.pictures = std::move(*pictures);
  auto all = plan.outputs;
  all.insert(all.end(), plan.pictures.begin(), plan.pictures.end());
  if (auto const error = find_collision(inputs, all)) return *error;
  for (auto const& output : plan.outputs) {
    auto const format = output.empty() ? DrawingFormat::Svg : drawing_format(output);
    if (!format) return format.error();
    plan.formats.push_back(*format);
  }
  return plan;
}

std::optional<Error> write_outputs(Drawing const& drawing, SimplifyPlan const& plan, int index) {
  if (auto const& output = plan.outputs[index]; !output.empty()) {
    if (auto error = write_drawing(drawing, plan.formats[index], output)) return error;
  }
  auto const& picture = plan.pictures[index];
  return picture.empty() ? std::nullopt : write_drawing_picture(drawing, picture);
}

Result<Json> simplify_one(SimplifyCall const& call, SimplifyPlan const& plan, int index,
                          ProgressLine& line) {
  auto const& input = call.shared.inputs[index];
  StageClock clock;
  Progress const shown = {[&](std::string_view stage) { line.show(stage); }, {}};
  Progress const progress = clock.timed(shown);
  progress.report("read");
  auto const content = read_file(input);
  if (!content) return content.error();
  auto const read = read_sketch(*content);
  if (!read) return read.error();
  if (!call.shared.is_quiet) {
    for (auto const& warning : read->warnings) print_warning(input, warning);
  }
  auto const drawing = run_simplify(read->source, plan.options, progress);
  if (!drawing) return drawing.error();
  progress.report("write");
  if (auto const error = write_outputs(*drawing, plan, index)) return *error;
  clock.stop();
  if (!call.shared.is_json) return Json::object();
  return Json::parse(json_report(*drawing, clock.times()));
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

template <typename Choice>
using Choices = std::map<std::string, Choice>;

template <typename Choice>
void add_choice(CLI::App& verb, std::string const& name, Choice& choice,
                Choices<Choice> const& choices, std::string const& description) {
  std::string words;
  for (auto const& [word, value] : choices) words += (words.empty() ? "" : "|") + word;
  auto const choose = [&choice, choices](std::string const& word) { choice = choices.at(word); };
  verb.add_option_function<std::string>(name, choose, description)
      ->check(CLI::IsMember(choices).description(""))
      ->type_name(words);
}

void add_marks(CLI::App& verb, std::string const& name, std::vector<std::string>& marks,
               std::string const& description) {
  verb.add_option(name, marks, description)->type_name("X,Y")->allow_extra_args(false);
}

}  // namespace

Verb declare_simplify(CLI::App& program) {
  auto const call = std::make_shared<SimplifyCall>();
  auto& verb = *program.add_subcommand("simplify", "Close rough strokes into clean contours");
  add_shared_options(verb, call->shared);
  verb.add_option("--picture", call->picture, "Also write a picture to look at (PNG), or FOLDER/")
      ->type_name("FILE");
  verb.add_option("--gap", call->gap, "Largest gap to close, px of the output canvas")
      ->type_name("auto|PX");
  add_marks(verb, "--outside", call->outside, "This place is background (may be repeated)");
  add_marks(verb, "--inside", call->inside, "This place belongs to the shape (may be repeated)");
  add_choice<SimplifyMethod>(verb, "--method", call->method,
                             {{"cut", SimplifyMethod::Cut}, {"grid", SimplifyMethod::Grid}},
                             "Where the cut is made: between strokes, or on pixels");
  add_choice<Holes>(verb, "--holes", call->holes, {{"keep", Holes::Keep}, {"fill", Holes::Fill}},
                    "Whether enclosed white stays open");
  add_choice<Parts>(verb, "--parts", call->parts,
                    {{"all", Parts::All}, {"groups", Parts::Groups}, {"one", Parts::One}},
                    "Every piece, one layer for each group, or the largest piece");
  verb.add_option("--smooth", call->smooth, "How far contours may leave the pen's jitter")
      ->type_name("0..1");
  verb.add_option("--size", call->size, "Longer side of the output canvas, px")->type_name("N");
  verb.add_flag("--fit", call->fits, "Centre the strokes on a square canvas, 0.86 of its size");
  return {&verb, [call] { return run_simplify_verb(*call); }};
}

}  // namespace inkflate::cli
