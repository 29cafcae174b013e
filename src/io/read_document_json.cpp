// SPDX-License-Identifier: Apache-2.0
#include "io/read_document_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "io/parse_json.h"
#include "io/sketch_limits.h"
#include "io/svg_colour.h"

namespace inkflate {
namespace {

using Json = nlohmann::json;

constexpr double kAnyNumber = std::numeric_limits<double>::max();

/// Takes values out of JSON. After the first one that is missing or wrong all that is taken is of no use, but harmless; the
/// caller looks at fault() at the end.
class JsonTaker {
 public:
  std::optional<Error> const& fault() const { return fault_; }

  /// What is being read, for the message: "layer 3".
  void enter(char const* kind, std::ptrdiff_t index) {
    place_ = std::string(kind) + " " + std::to_string(index);
    index_ = index;
  }

  void fail(std::string const& what, ErrorCode code = ErrorCode::BadInput) {
    if (fault_) return;
    fault_ = Error{code, "document.json: " + (place_.empty() ? "" : place_ + ": ") + what, index_};
  }

  /// A member of an object; null where there is none.
  Json const* find(Json const& object, char const* name) const {
    if (!object.is_object()) return nullptr;
    auto const found = object.find(name);
    return found == object.end() ? nullptr : &*found;
  }

  /// The elements of a member that is an array; without any where it is missing.
  Json::array_t const& list(Json const& object, char const* name) {
    auto const* const value = find(object, name);
    if (value == nullptr) return none_;
    auto const* const elements = value->get_ptr<Json::array_t const*>();
    if (elements == nullptr) fail(std::string(name) + " is no list");
    return elements == nullptr ? none_ : *elements;
  }

  double number(Json const* value, char const* name, double least, double most) {
    double const result = value != nullptr && value->is_number() ? value->get<double>() : NAN;
    if (result >= least && result <= most) return result;
    fail(std::string(name) + " is missing or no number in its range");
    return least;
  }

  /// An integer in least .. count - 1.
  int index(Json const* value, char const* name, int least, std::ptrdiff_t count) {
    double const result = number(value, name, least, static_cast<double>(count) - 1);
    if (result == std::floor(result)) return static_cast<int>(result);
    fail(std::string(name) + " is no whole number");
    return least;
  }

  std::string text(Json const* value, char const* name) {
    auto const* const found = value == nullptr ? nullptr : value->get_ptr<std::string const*>();
    if (found == nullptr) fail(std::string(name) + " is missing or no text");
    return found == nullptr ? std::string() : *found;
  }

  Colour colour(Json const* value, char const* name) {
    auto const parsed = parse_colour(text(value, name));
    if (!parsed) fail(std::string(name) + " is no colour");
    return parsed.value_or(Colour{});
  }

  /// The kind that the text names.
  template <typename Kind>
  Kind kind(Json const* value, std::initializer_list<Kind> kinds) {
    auto const name = text(value, "kind");
    for (auto const each : kinds) {
      if (word(each) == name) return each;
    }
    fail("there is no kind \"" + name.substr(0, 20) + "\"");
    return *kinds.begin();
  }

 private:
  std::optional<Error> fault_;
  Json::array_t const none_ = {};
  std::string place_;
  long long index_ = -1;
};

class DocumentReader {
 public:
  Result<DocumentFile> read(Json const& json) && {
    check_version(json);
    if (take_.fault()) return *take_.fault();
    auto& sketch = document_.drawing.sketch;
    auto const* const canvas = take_.find(json, "canvas");
    Json const none;
    auto const& size = canvas == nullptr ? none : *canvas;
    sketch.width_px =
        take_.number(take_.find(size, "width"), "the canvas' width", 0, kCoordinateLimit);
    sketch.height_px =
        take_.number(take_.find(size, "height"), "the canvas' height", 0, kCoordinateLimit);
    if (auto const* const name = take_.find(json, "template")) {
      document_.template_name = take_.text(name, "template");
    }
    for (auto const& group : take_.list(json, "groups")) read_group(group);
    for (auto const& stroke : take_.list(json, "strokes")) {
      if (!take_.fault()) read_stroke(stroke);
    }
    for (auto const& layer : take_.list(json, "layers")) {
      if (!take_.fault()) read_layer(layer);
    }
    read_strokes(json, "stray", document_.drawing.stray);
    if (take_.fault()) return *take_.fault();
    return std::move(document_);
  }

 private:
  void check_version(Json const& json) {
    if (take_.text(take_.find(json, "format"), "format") != kDocumentFormat) {
      return take_.fail("not an Inkflate document");
    }
    double const version = take_.number(take_.find(json, "version"), "version", 1, kAnyNumber);
    if (version <= kDocumentVersion) return;
    take_.fail("made by a newer version of Inkflate than this one; please update",
               ErrorCode::Unsupported);
  }

  std::ptrdiff_t stroke_count() const { return std::ssize(document_.drawing.sketch.strokes); }

  void read_look(Json const& json, std::string& name, std::optional<Colour>& fill,
                 double& thickness) {
    name = take_.text(take_.find(json, "name"), "name");
    if (auto const* const value = take_.find(json, "fill")) fill = take_.colour(value, "fill");
    if (auto const* const value = take_.find(json, "thickness")) {
      thickness = take_.number(value, "thickness", kLeastThickness, kLargestThickness);
    }
  }

  void read_group(Json const& json) {
    auto& groups = document_.drawing.sketch.groups;
    take_.enter("group", std::ssize(groups));
    StrokeGroup group;
    read_look(json, group.name, group.fill, group.thickness);
    groups.push_back(std::move(group));
  }

  void read_per_sample(Json const& json, char const* name, double Sample::*member, double most,
                       std::vector<Sample>& samples) {
    if (take_.find(json, name) == nullptr) return;
    auto const& numbers = take_.list(json, name);
    if (numbers.size() != samples.size())
      return take_.fail(std::string(name) + " are not one for each position");
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      samples[i].*member = take_.number(&numbers[i], name, 0, most);
    }
  }

  void read_stroke(Json const& json) {
    auto& sketch = document_.drawing.sketch;
    take_.enter("stroke", std::ssize(sketch.strokes));
    Stroke stroke;
    stroke.kind = take_.kind(take_.find(json, "kind"), {StrokeKind::Ink, StrokeKind::HelpLine});
    stroke.width_px = take_.number(take_.find(json, "width"), "width", 0, kCoordinateLimit);
    stroke.colour = take_.colour(take_.find(json, "colour"), "colour");
    if (auto const* const group = take_.find(json, "group")) {
      stroke.group = take_.index(group, "group", 0, std::ssize(sketch.groups));
    }
    for (auto const position : points(json, "positions")) stroke.samples.push_back({position});
    read_per_sample(json, "pressures", &Sample::pressure, 1, stroke.samples);
    read_per_sample(json, "times", &Sample::time_s, kAnyNumber, stroke.samples);
    sample_count_ += std::ssize(stroke.samples);
    if (sample_count_ > kSampleLimit) {
      return take_.fail("more than 5 000 000 samples", ErrorCode::TooLarge);
    }
    sketch.strokes.push_back(std::move(stroke));
  }

  std::vector<Vec2> points(Json const& json, char const* name) {
    auto const& numbers = take_.list(json, name);
    if (numbers.size() % 2 != 0) take_.fail(std::string(name) + " are no pairs of numbers");
    std::vector<Vec2> result;
    result.reserve(numbers.size() / 2);
    auto const coordinate = [&](std::size_t i) {
      return take_.number(&numbers[i], name, -kCoordinateLimit, kCoordinateLimit);
    };
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      double const x = coordinate(i);
      result.push_back({x, coordinate(i + 1)});
    }
    return result;
  }

  void read_strokes(Json const& json, char const* name, std::vector<int>& strokes) {
    for (auto const& stroke : take_.list(json, name)) {
      strokes.push_back(take_.index(&stroke, name, 0, stroke_count()));
    }
  }

  void read_layer(Json const& json) {
    auto& layers = document_.drawing.layers;
    take_.enter("layer", std::ssize(layers));
    Layer layer;
    read_look(json, layer.name, layer.fill, layer.thickness);
    for (auto const& outline : take_.list(json, "outlines")) {
      layer.outlines.push_back(read_outline(outline));
    }
    read_strokes(json, "strokes", layer.strokes);
    read_strokes(json, "details", layer.details);
    layers.push_back(std::move(layer));
  }

  Outline read_outline(Json const& json) {
    Outline outline;
    outline.pieces = read_pieces(json);
    for (auto const& source : take_.list(json, "sources")) {
      auto const* const values = source.get_ptr<Json::array_t const*>();
      if (values == nullptr || values->size() != 5) {
        take_.fail("a source is no list of five numbers");
        break;
      }
      auto const value = [&](std::size_t i) {
        return take_.number(&(*values)[i], "source", -kAnyNumber, kAnyNumber);
      };
      InkSource read;
      read.from = value(0);
      read.to = value(1);
      read.stroke = take_.index(&(*values)[2], "the stroke of a source", -1, stroke_count());
      read.sample_from = value(3);
      read.sample_to = value(4);
      outline.sources.push_back(read);
    }
    return outline;
  }

  std::vector<OutlinePiece> read_pieces(Json const& json) {
    auto const corners = points(json, "points");
    std::size_t const count = corners.empty() ? 0 : (corners.size() - 1) / 3;
    bool const is_chain = corners.empty() || (corners.size() == 3 * count + 1 && count > 0 &&
                                              corners.front() == corners.back());
    if (!is_chain) {
      take_.fail("the points of an outline are no closed chain of curves");
      return {};
    }
    std::vector<OutlinePiece> pieces(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 4; ++k) pieces[i].curve.control[k] = corners[3 * i + k];
    }
    std::size_t next = 0;
    for (auto const& run : take_.list(json, "kinds")) {
      auto const* const pair = run.get_ptr<Json::array_t const*>();
      if (pair == nullptr || pair->size() != 2) break;
      auto const kind =
          take_.kind(pair->data(), {RunKind::Ink, RunKind::HelpLine, RunKind::Closing});
      int const size = take_.index(&(*pair)[1], "the size of a run", 0, std::ssize(pieces) + 1);
      for (int i = 0; i < size && next < count; ++i) pieces[next++].kind = kind;
    }
    if (next != count) take_.fail("an outline has not one kind for each curve");
    return pieces;
  }

  JsonTaker take_;
  DocumentFile document_;
  long long sample_count_ = 0;
};

}  // namespace

Result<DocumentFile> read_document_json(std::string_view text) {
  auto const json = parse_json(text);
  if (!json) return Error{json.error().code, "document.json: " + json.error().message};
  return DocumentReader().read(*json);
}

}  // namespace inkflate
