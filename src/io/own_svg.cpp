// SPDX-License-Identifier: Apache-2.0
#include "io/own_svg.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "io/numbers.h"
#include "io/sketch_limits.h"
#include "io/svg_colour.h"
#include "io/svg_style.h"
#include "io/svg_units.h"
#include "io/xml_text.h"

namespace inkflate {
namespace {

constexpr double kLongestTime = std::numeric_limits<double>::max();
constexpr int kShortestPiece = 11;  // bytes of six numbers in a path

// The functions below return false where the text is damaged.

bool take_char(std::string_view& text, char wanted) {
  skip_separator(text, Separator::Blank);
  if (text.empty() || text.front() != wanted) return false;
  text.remove_prefix(1);
  return true;
}

bool take_finite(std::string_view& text, double& number) {
  skip_separator(text, Separator::Blank);
  auto const taken = take_number(text);
  number = taken.value_or(0);
  return taken && std::isfinite(*taken);
}

bool take_point(std::string_view& text, Vec2& point) {
  return take_finite(text, point.x) && take_finite(text, point.y) &&
         std::abs(point.x) <= kCoordinateLimit && std::abs(point.y) <= kCoordinateLimit;
}

bool parse_size(std::string_view text, double& size) {
  return take_finite(text, size) && size >= 0 && size <= kCoordinateLimit && text.empty();
}

bool parse_indices(std::string_view text, int count, std::vector<int>& indices) {
  skip_separator(text, Separator::Blank);
  while (!text.empty()) {
    auto const index = take_index(text);
    if (!index || *index >= count) return false;
    indices.push_back(*index);
    skip_separator(text, Separator::Blank);
  }
  return true;
}

bool parse_positions(std::string_view path, std::vector<Sample>& samples) {
  while (!(path = trimmed(path)).empty()) {
    if (samples.size() < 2) take_char(path, samples.empty() ? 'M' : 'L');
    Sample sample;
    if (!take_point(path, sample.position)) return false;
    samples.push_back(sample);
  }
  return true;
}

// One number for each sample; without a list all keep what they have.
bool parse_per_sample(std::optional<std::string_view> numbers, double Sample::*member, double most,
                      std::vector<Sample>& samples) {
  if (!numbers) return true;
  for (auto& sample : samples) {
    if (!take_finite(*numbers, sample.*member)) return false;
    if (sample.*member < 0 || sample.*member > most) return false;
  }
  return trimmed(*numbers).empty();
}

bool parse_samples(SvgElement const& element, std::vector<Sample>& samples) {
  return parse_positions(element["d"], samples) &&
         parse_per_sample(element.find("inkflate:pressure"), &Sample::pressure, 1, samples) &&
         parse_per_sample(element.find("inkflate:time"), &Sample::time_s, kLongestTime, samples);
}

// Of a group or a layer. Files of the first version have neither.
bool parse_look(SvgElement const& element, std::optional<Colour>& fill, double& thickness) {
  if (auto const text = element.find("inkflate:fill")) {
    fill = parse_colour(*text);
    if (!fill) return false;
  }
  auto const text = element.find("inkflate:thickness");
  auto const number = text ? parse_thickness(*text) : thickness;
  thickness = number.value_or(thickness);
  return number.has_value();
}

bool parse_stroke(SvgElement const& element, int group_count, Stroke& stroke) {
  if (element["class"] == "help") stroke.kind = StrokeKind::HelpLine;
  auto const colour = parse_colour(element["stroke"]);
  if (!colour || !parse_size(element["stroke-width"], stroke.width_px)) return false;
  auto opacity_text = element.find("stroke-opacity").value_or("1");
  double opacity = 1;
  if (!take_finite(opacity_text, opacity)) return false;
  stroke.colour = with_opacity(*colour, opacity);
  if (auto group = element.find("inkflate:group")) {
    auto const index = take_index(*group);
    if (!index || *index >= group_count) return false;
    stroke.group = *index;
  }
  if (auto const depth = element.find("inkflate:depth")) {
    if (*depth != "far") return false;
    stroke.depth = StrokeDepth::Far;
  }
  return parse_samples(element, stroke.samples);
}

bool parse_points(std::string_view text, std::vector<Vec2>& points) {
  while (!(text = trimmed(text)).empty()) {
    Vec2 point;
    if (!take_point(text, point)) return false;
    points.push_back(point);
  }
  return true;
}

// Of the drawing or of a layer.
bool parse_choice(SvgElement const& element, CloseChoice& choice) {
  if (auto text = element.find("inkflate:gap")) {
    double gap_px = 0;
    if (!take_finite(*text, gap_px) || !(gap_px > 0 && gap_px <= kCoordinateLimit) ||
        !text->empty())
      return false;
    choice.gap_px = gap_px;
  }
  return parse_points(element["inkflate:outside"], choice.outside) &&
         parse_points(element["inkflate:inside"], choice.inside);
}

bool parse_bend_pins(std::string_view text, std::vector<BendPin>& pins) {
  while (!(text = trimmed(text)).empty()) {
    BendPin pin;
    if (!take_point(text, pin.position)) return false;
    if (!take_char(text, ';')) {
      if (!take_finite(text, pin.turn_rad.emplace()) || !take_char(text, ';')) return false;
    }
    pins.push_back(pin);
  }
  return true;
}

// What a layer rarely has.
bool parse_state(SvgElement const& element, int stroke_count, Layer& layer) {
  if (auto text = element.find("inkflate:id")) {
    auto const id = take_index(*text);
    if (!id || !text->empty()) return false;
    layer.id = LayerId{*id};
  }
  layer.is_hidden = element["inkflate:hidden"] == "yes";
  layer.is_locked = element["inkflate:locked"] == "yes";
  layer.is_open = element["inkflate:open"] == "yes";
  return parse_indices(element["inkflate:noise"], stroke_count, layer.noise) &&
         parse_choice(element, layer.choice) &&
         parse_bend_pins(element["inkflate:bend-pins"], layer.bend_pins);
}

// piece_room is as many pieces as the path can hold: a count in a file is not believed.
bool parse_kinds(std::string_view text, std::int64_t piece_room, std::vector<Outline>& outlines) {
  while (!(text = trimmed(text)).empty()) {
    outlines.emplace_back();
    auto& pieces = outlines.back().pieces;
    while (!text.empty() && !is_blank(text.front())) {
      char const letter = text.front();
      text.remove_prefix(1);
      auto const count = take_index(text);
      if (!count || *count == 0 || *count > piece_room) return false;
      piece_room -= *count;
      if (letter != 'i' && letter != 'h' && letter != 'c') return false;
      auto const kind = letter == 'i'   ? RunKind::Ink
                        : letter == 'h' ? RunKind::HelpLine
                                        : RunKind::Closing;
      pieces.insert(pieces.end(), static_cast<std::size_t>(*count), OutlinePiece{{}, kind});
    }
  }
  return true;
}

bool parse_curves(std::string_view path, std::vector<Outline>& outlines) {
  for (auto& outline : outlines) {
    Vec2 position;
    if (!take_char(path, 'M') || !take_point(path, position) || !take_char(path, 'C')) return false;
    Vec2 const start = position;
    for (auto& piece : outline.pieces) {
      auto& control = piece.curve.control;
      control[0] = position;
      for (std::size_t i = 1; i < 4; ++i) {
        if (!take_point(path, control[i])) return false;
      }
      position = control[3];
    }
    if (!take_char(path, 'Z') || position != start) return false;
  }
  return trimmed(path).empty();
}

bool take_source(std::string_view& text, int stroke_count, InkSource& source) {
  double stroke = -1;
  bool const is_whole = take_finite(text, source.from) && take_finite(text, source.to) &&
                        take_finite(text, stroke) && take_finite(text, source.sample_from) &&
                        take_finite(text, source.sample_to) && take_char(text, ',');
  if (!is_whole || stroke < -1 || stroke >= stroke_count || stroke != std::floor(stroke)) {
    return false;
  }
  source.stroke = static_cast<int>(stroke);
  return true;
}

bool parse_sources(std::string_view text, int stroke_count, std::vector<Outline>& outlines) {
  for (auto& outline : outlines) {
    while (!take_char(text, ';')) {
      InkSource source;
      if (!take_source(text, stroke_count, source)) return false;
      outline.sources.push_back(source);
    }
  }
  return trimmed(text).empty();
}

class OwnReader {
 public:
  explicit OwnReader(SvgTree const& tree) : tree_(tree) {}

  Result<Drawing> read() && {
    auto const root = tree_.element(0);
    auto& sketch = drawing_.sketch;
    bool const has_size =
        parse_size(root["width"], sketch.width_px) && parse_size(root["height"], sketch.height_px);
    if (!has_size) return damaged(0);
    // Strokes first: layers refer to them, wherever another program may have moved the groups.
    for (auto const wanted : {kRoughClass, kLayerClass}) {
      for (int i = 1; i < tree_.nodes[0].end; i = end_of(i)) {
        auto const child = tree_.element(i);
        if (child.name() != "g" || child["class"] != wanted) continue;
        auto const bad_node = wanted == kRoughClass ? read_rough(i) : read_layer(i, child);
        if (bad_node) return damaged(*bad_node);
        if (sample_count_ > kSampleLimit) {
          return Error{ErrorCode::TooLarge, "the drawing has more than 5 000 000 samples"};
        }
      }
    }
    bool const has_rest = parse_indices(root["inkflate:stray"], stroke_count(), drawing_.stray) &&
                          parse_choice(root, drawing_.choice);
    if (!has_rest) return damaged(0);
    return std::move(drawing_);
  }

 private:
  int end_of(int node) const { return tree_.nodes[static_cast<std::size_t>(node)].end; }
  int stroke_count() const { return static_cast<int>(std::ssize(drawing_.sketch.strokes)); }

  Error damaged(int node) const {
    auto const offset = tree_.nodes[static_cast<std::size_t>(node)].offset;
    return {ErrorCode::BadInput,
            "the drawing data of this Inkflate SVG is damaged (element at byte " +
                std::to_string(offset) + "); the file may have been changed by another program",
            static_cast<long long>(offset)};
  }

  // These return the element that is damaged, if one is.

  std::optional<int> read_rough(int group) {
    auto& sketch = drawing_.sketch;
    for (int i = group + 1; i < end_of(group); i = end_of(i)) {
      auto const element = tree_.element(i);
      if (element.full_name() == "inkflate:group") {
        StrokeGroup read = {clean_utf8(element["name"])};
        if (!parse_look(element, read.fill, read.thickness)) return i;
        sketch.groups.push_back(std::move(read));
      } else if (element.name() == "path") {
        Stroke stroke;
        int const group_count = static_cast<int>(std::ssize(sketch.groups));
        if (!parse_stroke(element, group_count, stroke)) return i;
        sample_count_ += std::ssize(stroke.samples);
        if (sample_count_ > kSampleLimit) return std::nullopt;
        sketch.strokes.push_back(std::move(stroke));
      }
    }
    return std::nullopt;
  }

  std::optional<int> read_layer(int group, SvgElement const& element) {
    Layer layer;
    layer.name = clean_utf8(element["inkflate:name"]);
    bool const has_lists =
        parse_indices(element["inkflate:strokes"], stroke_count(), layer.strokes) &&
        parse_indices(element["inkflate:details"], stroke_count(), layer.details) &&
        parse_look(element, layer.fill, layer.thickness) &&
        parse_state(element, stroke_count(), layer);
    if (!has_lists) return group;
    for (int i = group + 1; i < end_of(group); i = end_of(i)) {
      auto const child = tree_.element(i);
      if (child.name() != "path" || child["class"] != "fill") continue;
      bool const is_whole =
          layer.outlines.empty() &&
          parse_kinds(child["inkflate:kinds"], std::ssize(child["d"]) / kShortestPiece,
                      layer.outlines) &&
          parse_curves(child["d"], layer.outlines) &&
          parse_sources(child["inkflate:sources"], stroke_count(), layer.outlines);
      if (!is_whole) return i;
    }
    drawing_.layers.push_back(std::move(layer));
    return std::nullopt;
  }

  SvgTree const& tree_;
  Drawing drawing_;
  long long sample_count_ = 0;
};

}  // namespace

bool is_own_svg(SvgTree const& tree) {
  if (tree.element(0)["xmlns:inkflate"] != kOwnNamespace) return false;
  for (int i = 1; i < tree.nodes[0].end; i = tree.nodes[static_cast<std::size_t>(i)].end) {
    auto const child = tree.element(i);
    if (child.name() == "g" && child["class"] == kRoughClass) return true;
  }
  return false;
}

Result<Drawing> read_own_svg(SvgTree const& tree) { return OwnReader(tree).read(); }

}  // namespace inkflate
