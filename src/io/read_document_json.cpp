// SPDX-License-Identifier: Apache-2.0
#include "io/read_document_json.h"

#include <utility>

#include "io/clip_json.h"
#include "io/json_taker.h"
#include "io/layer_json.h"
#include "io/parse_json.h"
#include "io/sketch_limits.h"
#include "io/stroke_json.h"

namespace inkflate {
namespace {

using Json = nlohmann::json;

class DocumentReader {
 public:
  Result<DocumentFile> read(Json const& json) && {
    check_version(json);
    if (take_.fault()) return *take_.fault();
    read_canvas(json);
    if (auto const* const name = take_.find(json, "template")) {
      document_.template_name = take_.text(name, "template");
    }
    read_strokes(json);
    read_layers(json);
    read_motion(json);
    if (take_.fault()) return *take_.fault();
    return std::move(document_);
  }

 private:
  Sketch& sketch() { return document_.project.drawing.sketch; }

  void check_version(Json const& json) {
    if (take_.text(take_.find(json, "format"), "format") != kDocumentFormat) {
      return take_.fail("not an Inkflate document");
    }
    double const version = take_.number(take_.find(json, "version"), "version", 1, kAnyNumber);
    if (version <= kDocumentVersion) return;
    take_.fail("made by a newer version of Inkflate than this one; please update",
               ErrorCode::Unsupported);
  }

  void read_canvas(Json const& json) {
    auto const* const canvas = take_.find(json, "canvas");
    Json const none;
    auto const& size = canvas == nullptr ? none : *canvas;
    sketch().width_px =
        take_.number(take_.find(size, "width"), "the canvas' width", 0, kCoordinateLimit);
    sketch().height_px =
        take_.number(take_.find(size, "height"), "the canvas' height", 0, kCoordinateLimit);
  }

  void read_strokes(Json const& json) {
    auto& groups = sketch().groups;
    for (auto const& group : take_.list(json, "groups")) {
      take_.enter("group", std::ssize(groups));
      groups.push_back(take_group(take_, group));
    }
    long long sample_count = 0;
    for (auto const& stroke : take_.list(json, "strokes")) {
      if (take_.fault()) return;
      take_.enter("stroke", std::ssize(sketch().strokes));
      sketch().strokes.push_back(take_stroke(take_, stroke, std::ssize(groups)));
      sample_count += std::ssize(sketch().strokes.back().samples);
      if (sample_count > kSampleLimit) {
        take_.fail("more than 5 000 000 samples", ErrorCode::TooLarge);
      }
    }
  }

  void read_layers(Json const& json) {
    auto& drawing = document_.project.drawing;
    std::ptrdiff_t const stroke_count = std::ssize(drawing.sketch.strokes);
    for (auto const& layer : take_.list(json, "layers")) {
      if (take_.fault()) return;
      take_.enter("layer", std::ssize(drawing.layers));
      drawing.layers.push_back(take_layer(take_, layer, stroke_count));
    }
    drawing.stray = take_.indices(json, "stray", 0, stroke_count);
    if (auto const* const choice = take_.find(json, "choice")) {
      drawing.choice = take_choice(take_, *choice);
    }
  }

  void read_motion(Json const& json) {
    auto& project = document_.project;
    for (auto const& pin : take_.list(json, "pins")) {
      if (take_.fault()) return;
      take_.enter("pin", std::ssize(project.pins));
      project.pins.push_back(take_pin(take_, pin));
    }
    if (auto const* const clip = take_.find(json, "clip")) project.clip = take_clip(take_, *clip);
    if (auto const* const next = take_.find(json, "next_id")) {
      project.next_id = take_.index(next, "next_id", 1, kAnyCount);
    }
  }

  JsonTaker take_ = JsonTaker("document.json");
  DocumentFile document_;
};

}  // namespace

Result<DocumentFile> take_document(Json const& json) { return DocumentReader().read(json); }

Result<DocumentFile> read_document_json(std::string_view text) {
  auto const json = parse_json(text);
  if (!json) return Error{json.error().code, "document.json: " + json.error().message};
  return take_document(*json);
}

}  // namespace inkflate
