// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "cli/batch.h"
#include "cli/files.h"
#include "cli/verb.h"
#include "geometry/polyline.h"
#include "io/numbers.h"
#include "io/read_document.h"
#include "io/svg_colour.h"

namespace inkflate::cli {
namespace {

bool is_model(FileFormat format) {
  return format == FileFormat::Glb || format == FileFormat::Obj || format == FileFormat::Stl ||
         format == FileFormat::ThreeMf;
}

Json size_json(double width, double height) { return {{"width", width}, {"height", height}}; }

Json look_json(std::string const& name, std::optional<Colour> const& fill, double thickness) {
  Json json = {{"name", name}, {"thickness", thickness}};
  if (fill) json["fill"] = colour_hex(*fill);
  return json;
}

int count_runs(Layer const& layer, RunKind kind) {
  int count = 0;
  for (auto const& outline : layer.outlines) {
    for (auto const& run : runs(outline, 1)) count += run.kind == kind ? 1 : 0;
  }
  return count;
}

Json layer_json(Layer const& layer) {
  auto const holes =
      std::count_if(layer.outlines.begin(), layer.outlines.end(),
                    [](auto const& outline) { return signed_area(flatten(outline, 1)) < 0; });
  Json json = look_json(layer.name, layer.fill, layer.thickness);
  json["holes"] = holes;
  json["closings"] = count_runs(layer, RunKind::Closing);
  json["open"] = count_runs(layer, RunKind::HelpLine);
  json["strokes"] = layer.strokes.size();
  json["details"] = layer.details.size();
  if (!layer.noise.empty()) json["noise"] = layer.noise.size();
  if (layer.is_hidden) json["hidden"] = true;
  if (layer.is_locked) json["locked"] = true;
  if (layer.is_open) json["being_drawn"] = true;
  return json;
}

Json group_json(Sketch const& sketch, int index) {
  auto const& group = sketch.groups[static_cast<std::size_t>(index)];
  Json json = look_json(group.name, group.fill, group.thickness);
  json["strokes"] = std::count_if(sketch.strokes.begin(), sketch.strokes.end(),
                                  [&](Stroke const& stroke) { return stroke.group == index; });
  return json;
}

void add_drawing(Json& report, Drawing const& drawing) {
  auto const& sketch = drawing.sketch;
  std::size_t samples = 0;
  for (auto const& stroke : sketch.strokes) samples += stroke.samples.size();
  report["canvas"] = size_json(sketch.width_px, sketch.height_px);
  report["strokes"] = sketch.strokes.size();
  report["samples"] = samples;
  report["help_lines"] =
      std::count_if(sketch.strokes.begin(), sketch.strokes.end(),
                    [](Stroke const& stroke) { return stroke.kind == StrokeKind::HelpLine; });
  report["groups"] = report["layers"] = Json::array();
  for (int i = 0; i < std::ssize(sketch.groups); ++i) {
    report["groups"].push_back(group_json(sketch, i));
  }
  for (auto const& layer : drawing.layers) report["layers"].push_back(layer_json(layer));
  report["stray"] = drawing.stray.size();
}

Result<Json> report_on(std::string const& input, bool is_quiet) {
  auto const content = read_file(input);
  if (!content) return content.error();
  auto const format = sniff_format(*content);
  Json report = {{"format", file_format_name(format)}, {"bytes", content->size()}};
  if (is_model(format)) return report;
  auto const document = read_document(*content);
  if (!document) return document.error();
  if (!is_quiet) {
    for (auto const& warning : document->warnings) print_warning(input, warning);
  }
  report["warnings"] = document->warnings;
  if (auto const& scan = document->scan) {
    report["picture"] = size_json(scan->width, scan->height);
    return report;
  }
  add_drawing(report, document->project.drawing);
  if (auto const& pins = document->project.pins; !pins.empty()) report["pins"] = pins.size();
  if (auto const& clip = document->project.clip; clip.length_s > 0) {
    report["clip"] = {{"length", clip.length_s}, {"tracks", clip.tracks.size()}};
  }
  if (auto const& picture = document->project.template_picture) {
    report["template"] = size_json(picture->width, picture->height);
  }
  return report;
}

/// "3 strokes", "1 stroke"
std::string counted(Json const& count, std::string const& noun) {
  return count.dump() + " " + noun + (count == 1 ? "" : "s");
}

/// In quotes; bytes that are no UTF-8 become U+FFFD, control characters escapes.
std::string quoted(Json const& name) {
  return name.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string number(Json const& value) {
  std::string text;
  append_rounded(text, value.get<double>());
  return text;
}

std::string sides(Json const& size) {
  return number(size["width"]) + " x " + number(size["height"]) + " px";
}

std::string look_text(Json const& part) {
  std::string text = ", thickness " + number(part["thickness"]);
  if (part.contains("fill")) text += ", colour " + part["fill"].get<std::string>();
  return text;
}

std::string state_text(Json const& layer) {
  std::string text;
  if (layer.contains("noise")) text += ", " + counted(layer["noise"], "noise stroke");
  if (layer.contains("hidden")) text += ", hidden";
  if (layer.contains("locked")) text += ", locked";
  if (layer.contains("being_drawn")) text += ", being drawn";
  return text;
}

std::string as_lines(std::string const& input, Json const& report) {
  auto const format = report["format"].get<std::string>();
  std::string text = input + ": " + format + ", " + counted(report["bytes"], "byte") + "\n";
  if (report.contains("picture")) text += "  picture " + sides(report["picture"]) + "\n";
  if (!report.contains("canvas")) return text;
  text += "  canvas " + sides(report["canvas"]) + "\n";
  text += "  " + counted(report["strokes"], "stroke") + ", " +
          counted(report["samples"], "sample") + ", " + counted(report["help_lines"], "help line") +
          ", " + report["stray"].dump() + " stray\n";
  for (auto const& group : report["groups"]) {
    text += "  group " + quoted(group["name"]) + ": " + counted(group["strokes"], "stroke") +
            look_text(group) + "\n";
  }
  for (auto const& layer : report["layers"]) {
    text += "  part " + quoted(layer["name"]) + ": " + counted(layer["strokes"], "stroke") + ", " +
            counted(layer["details"], "detail") + ", " + counted(layer["holes"], "hole") + ", " +
            counted(layer["open"], "open run") + ", " + counted(layer["closings"], "closing") +
            look_text(layer) + state_text(layer) + "\n";
  }
  if (report.contains("pins")) text += "  " + counted(report["pins"], "pin") + "\n";
  if (report.contains("clip")) {
    text += "  clip of " + number(report["clip"]["length"]) + " s, " +
            counted(report["clip"]["tracks"], "track") + "\n";
  }
  if (report.contains("template")) text += "  template picture " + sides(report["template"]) + "\n";
  return text;
}

Result<Json> tell(SharedOptions const& options, int index) {
  auto const& input = options.inputs[static_cast<std::size_t>(index)];
  auto report = report_on(input, options.is_quiet);
  if (!report || options.is_json) return report;
  if (print(as_lines(one_line(input), *report))) return report;
  return Error{ErrorCode::FileSystem, "cannot write to standard output"};
}

ExitStatus run_info_verb(SharedOptions const& options) {
  if (!options.output.empty()) {
    return refuse(options, {ErrorCode::BadOption, "info writes no file; leave out -o"});
  }
  return run_batch(options, [&](int index) { return tell(options, index); });
}

}  // namespace

Verb declare_info(CLI::App& program) {
  auto const options = std::make_shared<SharedOptions>();
  auto& verb = *program.add_subcommand("info", "Tell what a file holds");
  add_shared_options(verb, *options);
  return {&verb, [options] { return run_info_verb(*options); }};
}

}  // namespace inkflate::cli
