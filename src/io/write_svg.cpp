// SPDX-License-Identifier: Apache-2.0
#include "io/write_svg.h"

#include <algorithm>
#include <span>

#include "io/numbers.h"
#include "io/own_svg.h"
#include "io/svg_colour.h"
#include "io/xml_text.h"

namespace inkflate {
namespace {

constexpr Colour kFillColour = {0xf4, 0xec, 0xdd};
constexpr std::string_view kNotDisplayed = " style=\"display:none\"";

// Exact numbers carry the data, rounded ones are only looked at.
using AppendNumber = void (*)(std::string&, double);

void append_point(std::string& text, Vec2 point, AppendNumber append) {
  append(text, point.x);
  text += ' ';
  append(text, point.y);
}

void append_polyline(std::string& text, std::span<Sample const> samples, AppendNumber append) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    text += i == 0 ? "M" : i == 1 ? "L" : " ";
    append_point(text, samples[i].position, append);
  }
}

void append_curve(std::string& text, Cubic const& curve, AppendNumber append) {
  for (std::size_t i = 1; i < 4; ++i) {
    append_point(text, curve.control[i], append);
    text += ' ';
  }
}

// name="value", the value made by a function of the text so far.
template <typename Append>
void append_attribute(std::string& text, std::string_view name, Append const& append) {
  text += ' ';
  text += name;
  text += "=\"";
  append(text);
  text += '"';
}

void append_text_attribute(std::string& text, std::string_view name, std::string_view value) {
  append_attribute(text, name, [&](std::string& t) { t += escape_xml(value); });
}

void append_number_attribute(std::string& text, std::string_view name, double value) {
  append_attribute(text, name, [&](std::string& t) { append_number(t, value); });
}

void append_indices(std::string& text, std::string_view name, std::vector<int> const& indices) {
  append_attribute(text, name, [&](std::string& t) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      t += (i == 0 ? "" : " ") + std::to_string(indices[i]);
    }
  });
}

void append_points(std::string& text, std::string_view name, std::vector<Vec2> const& points) {
  if (points.empty()) return;
  append_attribute(text, name, [&](std::string& t) {
    for (auto const point : points) {
      append_point(t, point, append_number);
      t += ' ';
    }
  });
}

void append_choice(std::string& text, CloseChoice const& choice) {
  if (choice.gap_px) append_number_attribute(text, "inkflate:gap", *choice.gap_px);
  append_points(text, "inkflate:outside", choice.outside);
  append_points(text, "inkflate:inside", choice.inside);
}

// #rrggbb, as every program knows it.
std::string opaque_hex(Colour colour) { return colour_hex(colour).substr(0, 7); }

// name is "stroke" or "fill".
void append_paint(std::string& text, std::string const& name, Colour colour) {
  append_text_attribute(text, name, opaque_hex(colour));
  if (colour.a == 255) return;
  append_attribute(text, name + "-opacity",
                   [&](std::string& t) { append_rounded(t, colour.a / 255.0); });
}

void append_pen(std::string& text, Stroke const& stroke) {
  append_paint(text, "stroke", stroke.colour);
  append_number_attribute(text, "stroke-width", stroke.width_px);
}

// Of a group or a layer, exactly.
void append_look(std::string& text, std::optional<Colour> const& fill, double thickness) {
  if (fill) append_text_attribute(text, "inkflate:fill", colour_hex(*fill));
  append_number_attribute(text, "inkflate:thickness", thickness);
}

// A list with one number for each sample, left out where all are what the reader takes without it.
void append_per_sample(std::string& text, std::string_view name, std::vector<Sample> const& samples,
                       double Sample::*member, double usual) {
  bool const is_usual = std::all_of(samples.begin(), samples.end(),
                                    [&](Sample const& sample) { return sample.*member == usual; });
  if (is_usual) return;
  append_attribute(text, name, [&](std::string& t) {
    for (auto const& sample : samples) {
      append_number(t, sample.*member);
      t += ' ';
    }
  });
}

void append_rough_stroke(std::string& text, Stroke const& stroke) {
  text += "<path";
  if (stroke.kind == StrokeKind::HelpLine) text += " class=\"help\"";
  append_attribute(text, "d",
                   [&](std::string& t) { append_polyline(t, stroke.samples, append_number); });
  append_pen(text, stroke);
  append_per_sample(text, "inkflate:pressure", stroke.samples, &Sample::pressure, 1);
  append_per_sample(text, "inkflate:time", stroke.samples, &Sample::time_s, 0);
  if (stroke.group >= 0) append_number_attribute(text, "inkflate:group", stroke.group);
  if (stroke.depth == StrokeDepth::Far) append_text_attribute(text, "inkflate:depth", "far");
  text += "/>\n";
}

void append_rough(std::string& text, Drawing const& drawing) {
  text += "<g";
  append_text_attribute(text, "class", kRoughClass);
  if (!drawing.layers.empty()) text += kNotDisplayed;
  text += " fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (auto const& group : drawing.sketch.groups) {
    text += "<inkflate:group";
    append_text_attribute(text, "name", group.name);
    append_look(text, group.fill, group.thickness);
    text += "/>\n";
  }
  for (auto const& stroke : drawing.sketch.strokes) append_rough_stroke(text, stroke);
  text += "</g>\n";
}

char kind_letter(RunKind kind) {
  return kind == RunKind::Ink ? 'i' : kind == RunKind::HelpLine ? 'h' : 'c';
}

// "i12h3 i7": the first outline has 12 pieces of ink, then 3 of help line; the second 7 of ink.
void append_kinds(std::string& text, std::vector<Outline> const& outlines) {
  for (auto const& outline : outlines) {
    auto const& pieces = outline.pieces;
    for (std::size_t i = 0, next = 0; i < pieces.size(); i = next) {
      while (next < pieces.size() && pieces[next].kind == pieces[i].kind) ++next;
      text += kind_letter(pieces[i].kind) + std::to_string(next - i);
    }
    text += ' ';
  }
}

// Per outline its sources with a ',' after each, then ';'.
void append_sources(std::string& text, std::vector<Outline> const& outlines) {
  for (auto const& outline : outlines) {
    for (auto const& source : outline.sources) {
      for (double const number : {source.from, source.to, static_cast<double>(source.stroke),
                                  source.sample_from, source.sample_to}) {
        append_number(text, number);
        text += ' ';
      }
      text.back() = ',';
    }
    text += ';';
  }
}

void append_area(std::string& text, Layer const& layer) {
  auto const& outlines = layer.outlines;
  text += "<path class=\"fill\"";
  append_attribute(text, "d", [&](std::string& t) {
    for (auto const& outline : outlines) {
      if (outline.pieces.empty()) continue;
      t += 'M';
      append_point(t, outline.pieces[0].curve.start(), append_number);
      t += 'C';
      for (auto const& piece : outline.pieces) append_curve(t, piece.curve, append_number);
      t.back() = 'Z';
    }
  });
  append_attribute(text, "inkflate:kinds", [&](std::string& t) { append_kinds(t, outlines); });
  append_attribute(text, "inkflate:sources", [&](std::string& t) { append_sources(t, outlines); });
  text += " fill-rule=\"nonzero\" stroke=\"none\"";
  append_paint(text, "fill", layer.fill.value_or(kFillColour));
  text += "/>\n";
}

// The contour's lines look the same whatever the size of the canvas.
double line_width_px(Sketch const& sketch) {
  double const side = std::max(sketch.width_px, sketch.height_px);
  return side > 0 ? side / 300 : 1;
}

// Dash and gap in widths of the line.
void append_run_style(std::string& text, std::string_view kind, std::string_view colour,
                      Vec2 dashes, double width_px) {
  append_text_attribute(text, "class", "contour " + std::string(kind));
  append_text_attribute(text, "stroke", colour);
  append_attribute(text, "stroke-width", [&](std::string& t) { append_rounded(t, width_px); });
  if (dashes == Vec2{}) return;
  append_attribute(text, "stroke-dasharray",
                   [&](std::string& t) { append_point(t, dashes * width_px, append_rounded); });
}

void append_run_style(std::string& text, RunKind kind, double width_px) {
  switch (kind) {
    case RunKind::Ink:
      return append_run_style(text, "ink", "#22242b", {}, width_px);
    case RunKind::HelpLine:
      return append_run_style(text, "help", "#1f8a7d", {3, 2.5}, width_px);
    case RunKind::Closing:  // round caps make dots of dashes without length
      return append_run_style(text, "closing", "#e8604c", {0, 2}, width_px);
  }
}

// Begins where the kind changes, so that no run is cut in two by the outline's first point.
std::size_t first_of_a_run(std::vector<OutlinePiece> const& pieces) {
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (pieces[i].kind != pieces[i - 1].kind) return i;
  }
  return 0;
}

void append_runs(std::string& text, Outline const& outline, double width_px) {
  auto const& pieces = outline.pieces;
  std::size_t const count = pieces.size();
  std::size_t const first = first_of_a_run(pieces);
  for (std::size_t i = 0; i < count;) {
    auto const kind = pieces[(first + i) % count].kind;
    text += "<path";
    append_run_style(text, kind, width_px);
    append_attribute(text, "d", [&](std::string& t) {
      std::size_t const begin = i;
      t += 'M';
      append_point(t, pieces[(first + i) % count].curve.start(), append_rounded);
      t += 'C';
      for (; i < count && pieces[(first + i) % count].kind == kind; ++i) {
        append_curve(t, pieces[(first + i) % count].curve, append_rounded);
      }
      t.pop_back();
      if (i - begin == count) t += 'Z';
    });
    text += "/>\n";
  }
}

void append_pen_line(std::string& text, std::string_view name, Stroke const& stroke) {
  text += "<path";
  append_text_attribute(text, "class", name);
  append_attribute(text, "d",
                   [&](std::string& t) { append_polyline(t, stroke.samples, append_rounded); });
  append_pen(text, stroke);
  text += "/>\n";
}

void append_bend_pins(std::string& text, std::vector<BendPin> const& pins) {
  if (pins.empty()) return;
  append_attribute(text, "inkflate:bend-pins", [&](std::string& t) {
    for (auto const& pin : pins) {
      append_point(t, pin.position, append_number);
      if (pin.turn_rad) {
        t += ' ';
        append_number(t, *pin.turn_rad);
      }
      t += ';';
    }
  });
}

// What a layer rarely has.
void append_state(std::string& text, Layer const& layer) {
  if (!layer.noise.empty()) append_indices(text, "inkflate:noise", layer.noise);
  append_choice(text, layer.choice);
  append_bend_pins(text, layer.bend_pins);
  if (layer.id != LayerId::None) {
    append_number_attribute(text, "inkflate:id", static_cast<int>(layer.id));
  }
  if (layer.is_locked) append_text_attribute(text, "inkflate:locked", "yes");
  if (layer.is_open) append_text_attribute(text, "inkflate:open", "yes");
  if (!layer.is_hidden) return;
  append_text_attribute(text, "inkflate:hidden", "yes");
  text += kNotDisplayed;
}

// For viewers: details, and of a layer that has no outline yet what is drawn of it.
void append_pen_lines(std::string& text, Sketch const& sketch, Layer const& layer) {
  auto const append_all = [&](std::string_view name, std::vector<int> const& strokes) {
    for (int const stroke : strokes) {
      append_pen_line(text, name, sketch.strokes[static_cast<std::size_t>(stroke)]);
    }
  };
  if (layer.outlines.empty()) append_all("stroke", layer.strokes);
  append_all("detail", layer.details);
}

void append_layer(std::string& text, Drawing const& drawing, std::size_t index) {
  auto const& layer = drawing.layers[index];
  auto const& sketch = drawing.sketch;
  text += "<g";
  append_text_attribute(text, "id", "layer-" + std::to_string(index + 1));
  append_text_attribute(text, "class", kLayerClass);
  append_text_attribute(text, "inkflate:name", layer.name);
  append_indices(text, "inkflate:strokes", layer.strokes);
  append_indices(text, "inkflate:details", layer.details);
  append_look(text, layer.fill, layer.thickness);
  append_state(text, layer);
  text += " fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  append_area(text, layer);
  for (auto const& outline : layer.outlines) append_runs(text, outline, line_width_px(sketch));
  append_pen_lines(text, sketch, layer);
  text += "</g>\n";
}

}  // namespace

std::string write_svg(Drawing const& drawing) {
  auto const& sketch = drawing.sketch;
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
  append_text_attribute(text, "xmlns:inkflate", kOwnNamespace);
  append_number_attribute(text, "width", sketch.width_px);
  append_number_attribute(text, "height", sketch.height_px);
  append_attribute(text, "viewBox", [&](std::string& t) {
    t += "0 0 ";
    append_point(t, {sketch.width_px, sketch.height_px}, append_number);
  });
  append_indices(text, "inkflate:stray", drawing.stray);
  append_choice(text, drawing.choice);
  text += ">\n";
  append_rough(text, drawing);
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) append_layer(text, drawing, i);
  text += "</svg>\n";
  return text;
}

}  // namespace inkflate
