// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "cli/batch.h"
#include "cli/console.h"
#include "cli/drawing_outputs.h"
#include "cli/files.h"
#include "cli/load_project.h"
#include "cli/option_values.h"
#include "cli/output_plan.h"
#include "cli/pin_list.h"
#include "cli/pin_moves.h"
#include "cli/progress_line.h"
#include "cli/simplify_options.h"
#include "cli/verb.h"
#include "document/apply.h"
#include "io/json_report.h"
#include "pipeline/stage_clock.h"

namespace inkflate::cli {
namespace {

// Less is not seen in a drawing.
constexpr double kWorthTellingPx = 1;

/// The options as the user wrote them.
struct DeformCall {
  SharedOptions shared;
  std::string picture;
  std::string pin_file;
  std::vector<std::string> pins;
  std::optional<BendMode> mode;
  std::string body;
  SimplifyWords simplify;
};

/// What to do, checked.
struct DeformPlan {
  std::vector<PinWords> pins;
  BendOptions bend;
  RunSimplifyOptions simplify;
  DrawingOutputs outputs;
};

/// The pins of the file, then those of the command line.
std::optional<Error> plan_pins(DeformCall const& call, DeformPlan& plan) {
  PinFile file;
  if (!call.pin_file.empty()) {
    auto const content = read_file(call.pin_file);
    if (!content) {
      return Error{content.error().code, call.pin_file + ": " + content.error().message};
    }
    std::string_view const text(reinterpret_cast<char const*>(content->data()), content->size());
    auto read = read_pins(text, call.pin_file);
    if (!read) return read.error();
    file = *std::move(read);
  }
  plan.pins = std::move(file.pins);
  for (auto const& text : call.pins) {
    auto pin = parse_pin(text, static_cast<int>(&text - call.pins.data()) + 1);
    if (!pin) return pin.error();
    plan.pins.push_back(*std::move(pin));
  }
  if (plan.pins.empty()) {
    return Error{ErrorCode::BadOption,
                 "nothing to bend: give --pins FILE or --pin PART:X,Y:X,Y (see --help)"};
  }
  plan.bend.mode = call.mode.value_or(file.mode.value_or(BendMode::Body));
  if (!call.body.empty()) {
    if (plan.bend.mode == BendMode::Wire) {
      return Error{ErrorCode::BadOption, "--body belongs to --mode body"};
    }
    auto const body = checked_body("--body", parse_number(call.body));
    if (!body) return body.error();
    file.body = *body;
  }
  plan.bend.body = file.body.value_or(plan.bend.body);
  return std::nullopt;
}

Result<DeformPlan> make_plan(DeformCall const& call) {
  DeformPlan plan;
  auto outputs = plan_drawing_outputs(call.shared, call.picture, ".inkflate", {call.pin_file});
  if (!outputs) return outputs.error();
  plan.outputs = std::move(*outputs);
  if (auto const error = plan_pins(call, plan)) return *error;
  auto simplify = simplify_options(call.simplify);
  if (!simplify) return simplify.error();
  plan.simplify = std::move(*simplify);
  return plan;
}

bool goes(PinWords const& pin) { return pin.to || pin.turn_deg; }

/// A bend that was refused, by the pin that is to blame.
Error blamed(Error error, std::vector<PinWords> const& pins) {
  if (error.code == ErrorCode::NothingThere && std::none_of(pins.begin(), pins.end(), goes)) {
    error.message += "; a pin that goes somewhere has two places, PART:X,Y:X,Y";
  }
  if (error.index < 0 || error.index >= std::ssize(pins)) return error;
  error.message = pins[static_cast<std::size_t>(error.index)].source + ": " + error.message;
  return error;
}

std::string name_of(Document const& document, LayerId id) {
  auto const* const layer = find_layer(document, id);
  return layer == nullptr ? std::string() : layer->layer.name;
}

BendFacts facts_of(Document const& document, std::vector<BendMove> const& moves,
                   BentDocument const& bent) {
  BendFacts facts = {{}, {}, bent.steps, bent.is_settled};
  for (auto const& command : bent.commands) {
    auto const* const bend = std::get_if<Bend>(&command);
    if (bend == nullptr) continue;
    for (auto const& part : bend->parts) facts.parts.push_back(name_of(document, part.layer));
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    auto const& move = moves[i];
    facts.pins.push_back({name_of(document, move.layer), move.from, move.to, bent.ends[i]});
  }
  return facts;
}

/// The pin that is farthest from where it was to go, and how many more are not there; empty: all are.
std::string missed_pins(DeformPlan const& plan, std::vector<BendMove> const& moves,
                        BentDocument const& bent) {
  std::size_t worst = 0;
  double worst_px = 0;
  int count = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    double const off_px = distance(bent.ends[i], moves[i].to);
    if (off_px >= kWorthTellingPx) ++count;
    if (off_px <= worst_px) continue;
    worst = i;
    worst_px = off_px;
  }
  if (count == 0) return "";
  auto const others =
      count > 1 ? " (" + std::to_string(count - 1) + " more do not get there)" : std::string();
  return plan.pins[worst].source + " ends " + std::to_string(std::llround(worst_px)) +
         " px from where it was to go" + others + ": other pins or joints hold against it";
}

/// What came out otherwise than it was asked for.
void warn(std::string const& input, DeformPlan const& plan, std::vector<BendMove> const& moves,
          BentDocument const& bent) {
  if (auto const missed = missed_pins(plan, moves, bent); !missed.empty()) {
    print_warning(input, missed);
  }
  if (!bent.is_settled) {
    print_warning(input, "still moving after " + std::to_string(bent.steps) +
                             " steps; the bend is written as it was then");
  }
}

Result<Json> deform_one(DeformCall const& call, DeformPlan const& plan, int index,
                        ProgressLine& line) {
  StageClock clock;
  Progress const shown = {[&](std::string_view stage) { line.show(stage); }, {}};
  Progress const progress = clock.timed(shown);
  auto const place = static_cast<std::size_t>(index);
  auto const project =
      load_project(call.shared, call.shared.inputs[place], plan.simplify, progress);
  if (!project) return project.error();
  progress.report("deform");
  auto const document = make_document(*project);
  if (!document) return document.error();
  auto const moves = pin_moves(*document, plan.pins);
  if (!moves) return moves.error();
  auto const bent = bend_document(*document, *moves, plan.bend, progress);
  if (!bent) return blamed(bent.error(), plan.pins);
  if (!call.shared.is_quiet) warn(call.shared.inputs[place], plan, *moves, *bent);
  auto const result = inkflate::apply(*document, bent->commands);
  if (!result) return result.error();
  progress.report("write");
  if (auto const error = write_drawing_outputs(to_project(*result), plan.outputs, index)) {
    return *error;
  }
  clock.stop();
  if (!call.shared.is_json) return Json::object();
  return Json::parse(json_report(facts_of(*document, *moves, *bent), clock.times()));
}

ExitStatus run_deform_verb(DeformCall const& call) {
  auto const plan = make_plan(call);
  if (!plan) return refuse(call.shared, plan.error());
  for (auto const& folder : {call.shared.output, call.picture}) {
    if (auto const error = make_folder(folder)) return refuse(call.shared, *error);
  }
  ProgressLine line(call.shared.is_quiet ? ProgressLine::Mode::Off : ProgressLine::Mode::Automatic);
  return run_batch(call.shared, [&](int index) { return deform_one(call, *plan, index, line); });
}

}  // namespace

Verb declare_deform(CLI::App& program) {
  auto const call = std::make_shared<DeformCall>();
  call->simplify.parts = Parts::Groups;
  auto& verb = *program.add_subcommand("deform", "Bend parts of a drawing by pins");
  add_shared_options(verb, call->shared);
  verb.add_option("--picture", call->picture, "Also write a picture to look at (PNG), or FOLDER/")
      ->type_name("FILE");
  verb.add_option("--pins", call->pin_file,
                  "JSON: {\"pins\": [{\"part\", \"at\": [x, y], \"to\": [x, y],\n"
                  "\"turn\": degrees}]}; without \"to\" a pin holds its place")
      ->type_name("FILE");
  verb.add_option("--pin", call->pins,
                  "One more pin: of this part (its name or number) the place\n"
                  "nearest to X,Y goes to the second X,Y, or stays where there\n"
                  "is none; turned clockwise (may be repeated)")
      ->type_name("PART:X,Y[:X,Y][:DEGREES]")
      ->allow_extra_args(false);
  std::map<std::string, BendMode> const modes = {{"body", BendMode::Body},
                                                 {"wire", BendMode::Wire}};
  verb.add_option_function<std::string>(
          "--mode", [call, modes](std::string const& word) { call->mode = modes.at(word); },
          "The filled shape resists, or its line alone, as in the thesis")
      ->check(CLI::IsMember(modes).description(""))
      ->type_name("body|wire");
  verb.add_option("--body", call->body, "How stiff the inside is beside the line (1)")
      ->type_name("0.003..1");
  add_simplify_options(verb, call->simplify);
  return {&verb, [call] { return run_deform_verb(*call); }};
}

}  // namespace inkflate::cli
