// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "cli/batch.h"
#include "cli/files.h"
#include "cli/load_project.h"
#include "cli/option_values.h"
#include "cli/output_plan.h"
#include "cli/progress_line.h"
#include "cli/simplify_options.h"
#include "cli/verb.h"
#include "geometry/trig.h"
#include "io/svg_colour.h"
#include "io/write_png.h"
#include "pipeline/run_inflate.h"
#include "pipeline/stage_clock.h"
#include "render/bake_texture.h"
#include "render/draw_drawing.h"
#include "render/palette.h"
#include "render/rasterise.h"
#include "render/rasterise_model.h"

namespace inkflate::cli {
namespace {

enum class Look { Textured, Matcap, Lines, Drawing };

/// The options as the user wrote them.
struct RenderCall {
  SharedOptions shared;
  std::string turn = "30";
  std::string tilt = "12";
  std::string size = "1024";
  std::string background;
  Look look = Look::Textured;
  bool has_shadow = false;
};

/// What to do, checked.
struct RenderPlan {
  ModelView view;
  PictureSize size;
  std::optional<Colour> background;  // none: as it suits the look
  std::vector<std::string> outputs;
};

Error bad_value(std::string const& option, std::string const& range, std::string const& text) {
  return {ErrorCode::BadOption, option + " wants " + range + ", not " + text};
}

/// Degrees to radians; whole turns are taken off first, so that sine and cosine stay exact.
std::optional<double> parse_angle_rad(std::string const& text) {
  auto const degrees = parse_number(text);
  if (!degrees) return std::nullopt;
  return std::fmod(*degrees, 360) * kPi / 180;
}

Result<RenderPlan> make_plan(RenderCall const& call) {
  RenderPlan plan;
  auto const turn_rad = parse_angle_rad(call.turn);
  if (!turn_rad) return bad_value("--turn", "degrees", call.turn);
  auto const tilt_rad = parse_angle_rad(call.tilt);
  if (!tilt_rad) return bad_value("--tilt", "degrees", call.tilt);
  plan.view.turn_rad = *turn_rad;
  plan.view.tilt_rad = *tilt_rad;
  auto const size = parse_picture_size("--size", call.size);
  if (!size) return size.error();
  plan.size = *size;
  if (call.background == "none") {
    plan.background = Colour{0, 0, 0, 0};
  } else if (!call.background.empty()) {
    plan.background = parse_colour(call.background);
    if (!plan.background) return bad_value("--background", "none or a colour", call.background);
  }
  auto const& shared = call.shared;
  if (shared.output.empty()) return Error{ErrorCode::BadOption, "nothing to make: give -o OUTPUT"};
  if (shared.is_json && shared.output == kStandardStream) {
    return Error{ErrorCode::BadOption, "-o - and --json both want standard output; name a file"};
  }
  auto outputs = plan_outputs(shared.inputs, {"-o", shared.output, ".png"});
  if (!outputs) return outputs.error();
  plan.outputs = std::move(*outputs);
  if (auto const error = find_collision(shared.inputs, plan.outputs)) return *error;
  return plan;
}

/// The canvas fills the picture as far as its shape allows.
Result<Picture> picture_of_drawing(Drawing const& drawing, RenderPlan const& plan) {
  auto const& canvas = drawing.sketch;
  if (!(canvas.width_px > 0 && canvas.height_px > 0)) {
    return Error{ErrorCode::NothingThere, "the canvas has no size"};
  }
  double const scale =
      std::min(plan.size.width / canvas.width_px, plan.size.height / canvas.height_px);
  Vec2 const canvas_px = scale * Vec2{canvas.width_px, canvas.height_px};
  Vec2 const size_px = {static_cast<double>(plan.size.width),
                        static_cast<double>(plan.size.height)};
  auto const map = Affine::translation((size_px - canvas_px) / 2) * Affine::scaling(scale, scale);
  return rasterise(place(draw_drawing(drawing), map), plan.size.width, plan.size.height,
                   plan.background.value_or(palette::kPaper));
}

Result<Picture> picture_of_model(Drawing const& drawing, RenderCall const& call,
                                 RenderPlan const& plan, Progress const& progress) {
  auto const model = run_inflate(drawing, {}, progress);
  if (!model) return model.error();
  progress.report("render");
  Texture texture;
  if (call.look == Look::Textured) texture = bake_texture(drawing, *model);
  auto const shading = call.look == Look::Textured ? Shading::Textured
                       : call.look == Look::Matcap ? Shading::Matcap
                                                   : Shading::Lines;
  ModelPictureOptions const options = {plan.background.value_or(Colour{0, 0, 0, 0}),
                                       call.has_shadow ? GroundShadow::On : GroundShadow::Off};
  auto const list =
      draw_model(*model, &texture, plan.view, shading, plan.size.width, plan.size.height);
  return rasterise_model(list, plan.size.width, plan.size.height, options);
}

Result<Json> render_one(RenderCall const& call, RenderPlan const& plan, int index,
                        ProgressLine& line) {
  StageClock clock;
  Progress const told = {[&](std::string_view stage) { line.show(stage); }, {}};
  Progress const progress = clock.timed(told);
  RunSimplifyOptions simplify_options;
  simplify_options.simplify.parts = Parts::Groups;
  auto const project =
      load_project(call.shared, call.shared.inputs[index], simplify_options, progress);
  if (!project) return project.error();
  auto const picture = call.look == Look::Drawing
                           ? picture_of_drawing(project->drawing, plan)
                           : picture_of_model(shown(project->drawing), call, plan, progress);
  if (!picture) return picture.error();
  progress.report("write");
  if (auto const error = write_file(plan.outputs[index], write_png(*picture))) return *error;
  clock.stop();
  Json report = {{"width", plan.size.width}, {"height", plan.size.height}};
  for (auto const& stage : clock.times()) report["ms"][stage.stage] = stage.ms;
  return report;
}

ExitStatus run_render_verb(RenderCall const& call) {
  auto const plan = make_plan(call);
  if (!plan) return refuse(call.shared, plan.error());
  if (auto const error = make_folder(call.shared.output)) return refuse(call.shared, *error);
  ProgressLine line(call.shared.is_quiet ? ProgressLine::Mode::Off : ProgressLine::Mode::Automatic);
  return run_batch(call.shared, [&](int index) { return render_one(call, *plan, index, line); });
}

}  // namespace

Verb declare_render(CLI::App& program) {
  auto const call = std::make_shared<RenderCall>();
  auto& verb = *program.add_subcommand("render", "Make a picture of the 3D character");
  add_shared_options(verb, call->shared);
  verb.add_option("--turn", call->turn, "Walk around it to the right (30; 180: from behind)")
      ->type_name("DEG");
  verb.add_option("--tilt", call->tilt, "Rise above it (12)")->type_name("DEG");
  verb.add_option("--size", call->size, "Of the picture, px (1024)")->type_name("N|WxH");
  add_choice<Look>(verb, "--shading", call->look,
                   {{"textured", Look::Textured},
                    {"matcap", Look::Matcap},
                    {"lines", Look::Lines},
                    {"drawing", Look::Drawing}},
                   "The worn drawing, clay, ink on paper, or the flat drawing");
  verb.add_option("--background", call->background, "A colour as in CSS (none)")
      ->type_name("COLOUR|none");
  verb.add_flag("--shadow", call->has_shadow, "A soft shadow on the ground");
  return {&verb, [call] { return run_render_verb(*call); }};
}

}  // namespace inkflate::cli
