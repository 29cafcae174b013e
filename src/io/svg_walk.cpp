// SPDX-License-Identifier: Apache-2.0
#include "io/svg_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/numbers.h"
#include "io/svg_colour.h"
#include "io/svg_shapes.h"
#include "io/svg_units.h"
#include "io/xml_text.h"

namespace inkflate {
namespace {

constexpr std::string_view kLabel = "inkscape:label";
constexpr std::string_view kLayerMode = "inkscape:groupmode";

bool is_container(std::string_view name) { return name == "g" || name == "a" || name == "switch"; }

// What a person would miss, in contrast to definitions and metadata.
bool is_missed(std::string_view name) {
  return name == "text" || name == "image" || name == "foreignObject";
}

bool starts_with_help(std::string_view name) {
  return lower_ascii(trimmed(name).substr(0, 4)) == "help";
}

bool has_help_class(std::string_view classes) {
  while (!classes.empty()) {
    skip_separator(classes, Separator::Blank);
    if (starts_with_help(classes)) return true;
    classes.remove_prefix(std::min(classes.find_first_of(" \t\r\n"), classes.size()));
  }
  return false;
}

Declarations declarations_of(SvgElement const& element, StyleSheet const& sheet) {
  Declarations declarations;
  for (auto const& [name, value] : element.attributes()) declarations.declare(name, value);
  sheet.apply(element.name(), element["class"], element["id"], declarations);
  declarations.declare_all(element["style"]);
  return declarations;
}

bool is_usable_side(double side) { return side > 0 && side <= kCoordinateLimit; }

// The size that an svg element asks for; a side that is missing follows from the box's proportions.
std::optional<Vec2> wanted_size(SvgElement const& element, std::optional<ViewBox> const& box) {
  Vec2 const whole = box ? box->size : Vec2{0, 0};
  double const width = length_px(element["width"], whole.x).value_or(0);
  double const height = length_px(element["height"], whole.y).value_or(0);
  Vec2 size = {width, height};
  bool const has_width = is_usable_side(width);
  bool const has_height = is_usable_side(height);
  if (!has_width && box) size.x = has_height ? height * whole.x / whole.y : whole.x;
  if (!has_height && box) size.y = has_width ? width * whole.y / whole.x : whole.y;
  if (!is_usable_side(size.x) || !is_usable_side(size.y)) return std::nullopt;
  return size;
}

}  // namespace

SvgReading SvgWalk::run() && {
  bytes_left_ = std::ssize(tree_.document) + 64 * std::ssize(tree_.nodes) + limits_.copied_bytes;
  if (!tree_.style_sheet.is_complete()) warn("a style sheet that is too long", 0);
  frames_.push_back({1, tree_.nodes[0].end, enter_root(), -1, {}, {}});
  while (!frames_.empty()) {
    auto& frame = frames_.back();
    if (frame.next >= frame.end) {
      if (frame.use_node >= 0) open_uses_.pop_back();
      frames_.pop_back();
      continue;
    }
    int const node = frame.next;
    frame.next = tree_.nodes[static_cast<std::size_t>(node)].end;
    visit(node, Frame(frame));
  }
  auto& sketch = reading_.drawing.sketch;
  if (!has_canvas_) {
    Rect box;
    for (auto const& stroke : sketch.strokes) {
      for (auto const& sample : stroke.samples) box.include(sample.position);
    }
    sketch.width_px = box.is_empty() ? 1 : std::max(1.0, std::ceil(box.max.x));
    sketch.height_px = box.is_empty() ? 1 : std::max(1.0, std::ceil(box.max.y));
  }
  return std::move(reading_);
}

SvgWalk::Context SvgWalk::enter_root() {
  auto const root = tree_.element(0);
  auto const box = parse_view_box(root["viewBox"]);
  auto const size = wanted_size(root, box);
  has_canvas_ = size.has_value();
  Context context;
  // Without any size percentages refer to CSS's default for replaced elements.
  context.viewport = box ? box->size : size.value_or(Vec2{300, 150});
  if (size) {
    reading_.drawing.sketch.width_px = size->x;
    reading_.drawing.sketch.height_px = size->y;
    if (box) context.to_canvas = fit_view_box(*box, *size, root["preserveAspectRatio"]);
  }
  context.style =
      cascade({}, declarations_of(root, tree_.style_sheet), viewport_diagonal(context.viewport));
  find_group_level();
  return context;
}

std::vector<int> SvgWalk::children(int node) const {
  std::vector<int> found;
  for (int i = node + 1; i < tree_.nodes[static_cast<std::size_t>(node)].end;
       i = tree_.nodes[static_cast<std::size_t>(i)].end) {
    auto const name = tree_.element(i).name();
    if (is_container(name) || is_shape(name) || name == "use" || name == "svg") found.push_back(i);
  }
  return found;
}

/// Candidate layers are the groups below the root. A group around all of them only carries their common style: then they are the ones
/// in it. Around a single one it must say nothing of a part itself, and the one in it have a name.
void SvgWalk::find_group_level() {
  auto const is_group = [&](int node) { return tree_.element(node).name() == "g"; };
  auto const is_named = [&](int node) {
    auto const element = tree_.element(node);
    return element.find("id") || element.find(kLabel) || element[kLayerMode] == "layer";
  };
  auto const is_named_part = [&](int node) {
    auto const element = tree_.element(node);
    bool const is_help = starts_with_help(element.find(kLabel).value_or(element["id"]));
    return is_group(node) && is_named(node) && !is_help;
  };
  auto const says_nothing = [&](int node) {
    auto const element = tree_.element(node);
    return !is_named(node) && !element.find("data-fill") && !element.find("data-thickness");
  };
  auto level = children(0);
  while (level.size() == 1 && is_group(level[0])) {
    auto const below = children(level[0]);
    bool const is_around_one =
        below.size() == 1 && is_named_part(below[0]) && says_nothing(level[0]);
    if (!is_around_one && std::count_if(below.begin(), below.end(), is_group) < 2) break;
    ++group_depth_;
    level = below;
  }
  only_named_groups_ = std::any_of(level.begin(), level.end(), is_named_part);
}

void SvgWalk::visit(int node, Frame const& frame) {
  auto const element = tree_.element(node);
  auto const name = element.name();
  bytes_left_ -= 64 + static_cast<std::int64_t>(element.byte_count());
  if (bytes_left_ < 0) return warn("copied too often", node);
  if (is_missed(name)) return warn("text or a picture, which is not a line", node);
  bool const is_viewport = name == "svg" || (name == "symbol" && frame.use_node >= 0);
  if (!is_container(name) && !is_shape(name) && !is_viewport && name != "use") return;
  auto context = child_context(node, element, frame.context);
  if (!context.style.is_displayed) return;
  if (is_shape(name)) return visit_shape(node, element, context);
  if (name == "use") return visit_use(node, element, context);
  if (is_viewport) return visit_viewport(node, element, frame, context);
  if (name == "g") enter_group(node, element, context);
  frames_.push_back(
      {node + 1, tree_.nodes[static_cast<std::size_t>(node)].end, context, -1, {}, {}});
}

SvgWalk::Context SvgWalk::child_context(int node, SvgElement const& element,
                                        Context const& parent) {
  Context context = parent;
  context.style = cascade(parent.style, declarations_of(element, tree_.style_sheet),
                          viewport_diagonal(parent.viewport));
  if (has_help_class(element["class"])) context.is_help = true;
  if (auto const text = element.find("transform")) {
    auto const transform = parse_transform(*text);
    if (!transform) warn("a transform that cannot be read and was left out", node);
    context.to_canvas = context.to_canvas * transform.value_or(Affine{});
  }
  return context;
}

// A label is a name somebody gave; an id may come from a program and so never ends a group of help lines.
void SvgWalk::enter_group(int node, SvgElement const& element, Context& context) {
  auto const label = element.find(kLabel);
  if (label) context.is_help = starts_with_help(*label) || has_help_class(element["class"]);
  if (starts_with_help(element["id"])) context.is_help = context.is_help || !label;
  bool const is_named = label || element.find("id") || element[kLayerMode] == "layer";
  if (frames_.size() == group_depth_ && (is_named || !only_named_groups_) && !context.is_help) {
    context.group_node = node;
  }
}

void SvgWalk::enter_viewport(int node, SvgElement const& element, Place const& place,
                             Context& context) {
  auto const box = parse_view_box(element["viewBox"]);
  context.to_canvas = context.to_canvas * Affine::translation(place.position);
  context.viewport = place.size;
  if (box) {
    context.to_canvas =
        context.to_canvas * fit_view_box(*box, place.size, element["preserveAspectRatio"]);
    context.viewport = box->size;
  }
  frames_.push_back(
      {node + 1, tree_.nodes[static_cast<std::size_t>(node)].end, context, -1, {}, {}});
}

void SvgWalk::visit_viewport(int node, SvgElement const& element, Frame const& frame,
                             Context& context) {
  Vec2 const around = context.viewport;
  auto const length = [&](std::string_view attribute, double whole) {
    return length_px(element[attribute], whole);
  };
  bool const is_symbol = element.name() == "symbol";
  auto const width = is_symbol ? std::nullopt : length("width", around.x);
  auto const height = is_symbol ? std::nullopt : length("height", around.y);
  Vec2 const size = {frame.use_width.value_or(width.value_or(around.x)),
                     frame.use_height.value_or(height.value_or(around.y))};
  if (!(size.x > 0) || !(size.y > 0)) return;
  Vec2 const position = {length("x", around.x).value_or(0), length("y", around.y).value_or(0)};
  enter_viewport(node, element, {position, size}, context);
}

bool SvgWalk::contains_open_use(int node) const {
  return std::any_of(open_uses_.begin(), open_uses_.end(), [&](int use) {
    return node <= use && use < tree_.nodes[static_cast<std::size_t>(node)].end;
  });
}

void SvgWalk::visit_use(int node, SvgElement const& element, Context& context) {
  auto href = trimmed(element.find("href").value_or(element["xlink:href"]));
  if (href.empty()) return;
  if (href.front() != '#') return warn("a use of another file, which is never opened", node);
  auto const target = tree_.find_id(href.substr(1));
  if (!target) return warn("a use of something that is not in the file", node);
  if (std::ssize(open_uses_) >= limits_.use_depth) return warn("uses inside uses too deep", node);
  open_uses_.push_back(node);
  bool const is_cycle = contains_open_use(*target);
  bool const is_too_many = ++expansion_count_ > limits_.use_expansions;
  if (is_cycle || is_too_many) {
    open_uses_.pop_back();
    return warn(is_cycle ? "a use of itself" : "more uses than are expanded", node);
  }
  Vec2 const around = context.viewport;
  Vec2 const position = {length_px(element["x"], around.x).value_or(0),
                         length_px(element["y"], around.y).value_or(0)};
  context.to_canvas = context.to_canvas * Affine::translation(position);
  frames_.push_back({*target, tree_.nodes[static_cast<std::size_t>(*target)].end, context, node,
                     length_px(element["width"], around.x),
                     length_px(element["height"], around.y)});
}

void SvgWalk::visit_shape(int node, SvgElement const& element, Context const& context) {
  auto const& style = context.style;
  Colour const line = with_opacity(style.stroke.colour, style.opacity * style.stroke_opacity);
  Colour const area = with_opacity(style.fill.colour, style.opacity * style.fill_opacity);
  double const width = style.stroke_width * context.to_canvas.mean_scale();
  bool const is_stroked = !style.stroke.is_none && line.a > 0 && !(width <= 0);
  bool const is_far = is_stroked && !(width <= kCoordinateLimit);  // true for NaN too
  bool const is_filled = !style.fill.is_none && area.a > 0 && element.name() != "line";
  if (!style.is_visible || (!is_stroked && !is_filled)) return;
  PathTracer tracer(context.to_canvas,
                    std::min(limits_.points_per_element, limits_.samples - sample_count_));
  bool const is_whole = trace_shape(element, context.viewport, tracer);
  if (tracer.fault() == TraceFault::OutOfRange || is_far) {
    return warn("a coordinate beyond 1e6 px", node);
  }
  if (tracer.fault() == TraceFault::TooManyPoints) return warn("too many points", node);
  if (!is_whole) warn("damaged data, read up to the damage", node);
  auto subpaths = tracer.take_subpaths();
  if (!is_stroked && is_background(subpaths))
    return warn("a background that fills the canvas", node);
  if (std::ssize(reading_.drawing.sketch.strokes) + std::ssize(subpaths) > limits_.strokes) {
    return warn("too many strokes", node);
  }
  Stroke pen;
  pen.kind =
      context.is_help || (is_stroked && style.is_dashed) ? StrokeKind::HelpLine : StrokeKind::Ink;
  pen.width_px = is_stroked ? width : 1;
  pen.colour = is_stroked ? line : area;
  pen.group = context.group_node >= 0 && !subpaths.empty() ? group_index(context.group_node) : -1;
  add_strokes(std::move(subpaths), pen, !is_stroked);
}

void SvgWalk::add_strokes(std::vector<Polyline> subpaths, Stroke const& pen,
                          bool is_outline_of_area) {
  for (auto& points : subpaths) {
    if (is_outline_of_area && points.size() < 3) continue;  // encloses nothing, so nothing is seen
    if (is_outline_of_area && points.back() != points.front())
      points.push_back(Vec2(points.front()));
    Stroke stroke = pen;
    stroke.samples.reserve(points.size());
    for (auto const point : points) stroke.samples.push_back({point, 1});
    sample_count_ += static_cast<int>(std::ssize(points));
    reading_.drawing.sketch.strokes.push_back(std::move(stroke));
    points = {};
  }
}

// Drawing programs export their paper as a filled rectangle; nobody drew it.
bool SvgWalk::is_background(std::vector<Polyline> const& subpaths) const {
  auto const& sketch = reading_.drawing.sketch;
  if (!has_canvas_ || subpaths.size() != 1) return false;
  auto const box = bounds(subpaths[0]);
  bool const covers = box.min.x <= 1 && box.min.y <= 1 && box.max.x >= sketch.width_px - 1 &&
                      box.max.y >= sketch.height_px - 1;
  return covers && std::abs(signed_area(subpaths[0])) >= 0.999 * box.width() * box.height();
}

int SvgWalk::group_index(int node) {
  auto const known = group_of_node_.find(node);
  if (known != group_of_node_.end()) return known->second;
  auto& groups = reading_.drawing.sketch.groups;
  int const index = static_cast<int>(std::ssize(groups));
  auto const element = tree_.element(node);
  auto const name = trimmed(element.find(kLabel).value_or(element["id"]));
  StrokeGroup group;
  group.name = name.empty() ? "group " + std::to_string(index + 1) : clean_utf8(name);
  read_group_data(node, element, group);
  groups.push_back(std::move(group));
  group_of_node_[node] = index;
  return index;
}

void SvgWalk::read_group_data(int node, SvgElement const& element, StrokeGroup& group) {
  if (auto const text = element.find("data-fill")) {
    group.fill = parse_colour(trimmed(*text));
    if (!group.fill) warn("a data-fill that is no colour", node);
  }
  if (auto const text = element.find("data-thickness")) {
    auto const thickness = parse_thickness(*text);
    if (!thickness) warn("a data-thickness that is not within 0.1 .. 32", node);
    group.thickness = thickness.value_or(group.thickness);
  }
}

void SvgWalk::warn(std::string_view reason, int node) {
  auto& warnings = reading_.warnings;
  auto const same = std::find_if(warnings.begin(), warnings.end(),
                                 [&](SvgWarning const& entry) { return entry.reason == reason; });
  if (same != warnings.end()) {
    ++same->count;
  } else {
    auto const offset = tree_.nodes[static_cast<std::size_t>(node)].offset;
    warnings.push_back({std::string(reason), 1, static_cast<long long>(offset)});
  }
}

}  // namespace inkflate
