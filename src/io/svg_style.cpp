// SPDX-License-Identifier: Apache-2.0
#include "io/svg_style.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "io/numbers.h"
#include "io/svg_colour.h"
#include "io/svg_units.h"

namespace inkflate {
namespace {

// No value of ours is longer; a bound keeps the work per element small.
constexpr std::size_t kLongestValue = 1000;
constexpr int kClassLimit = 16;

constexpr std::array<std::string_view, kStylePropertyCount> kPropertyNames = {
    "color",  "display",          "fill",           "fill-opacity", "opacity",
    "stroke", "stroke-dasharray", "stroke-opacity", "stroke-width", "visibility"};

// Takes the text up to the delimiter, and the delimiter, off the front.
std::string_view take_until(std::string_view& text, char delimiter) {
  auto const end = std::min(text.find(delimiter), text.size());
  auto const part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

std::string without_comments(std::string_view css) {
  std::string clean;
  while (!css.empty()) {
    auto const begin = std::min(css.find("/*"), css.size());
    clean += css.substr(0, begin);
    if (begin == css.size()) break;
    clean += ' ';
    auto const end = css.find("*/", begin + 2);
    css = end == std::string_view::npos ? std::string_view{} : css.substr(end + 2);
  }
  return clean;
}

void set_opacity(std::string_view text, double& opacity) {
  auto const number = take_number(text);
  if (!number || !std::isfinite(*number)) return;
  double const value = trimmed(text) == "%" ? *number / 100 : *number;
  opacity = std::clamp(value, 0.0, 1.0);
}

void set_paint(std::string_view text, Colour current, Paint& paint) {
  text = trimmed(text);
  bool const is_server = text.substr(0, 4) == "url(";
  if (is_server) {  // a gradient: seen, but in which colour only its fallback tells
    take_until(text, ')');
    text = trimmed(text);
    if (text.empty() || text == "none") text = "black";
  }
  auto const lower = lower_ascii(text);
  if (lower == "none") {
    paint.is_none = true;
  } else if (lower == "currentcolor") {
    paint = {false, current};
  } else if (auto const colour = parse_colour(text)) {
    paint = {false, *colour};
  }
}

bool is_dash_pattern(std::string_view text) {
  skip_separator(text, Separator::Comma);
  while (auto const number = take_number(text)) {
    if (*number > 0) return true;
    while (!text.empty() && !is_blank(text.front()) && text.front() != ',') text.remove_prefix(1);
    skip_separator(text, Separator::Comma);
  }
  return false;
}

}  // namespace

void Declarations::declare(std::string_view name, std::string_view value) {
  if (value.size() > kLongestValue) return;
  for (std::size_t i = 0; i < kPropertyNames.size(); ++i) {
    if (kPropertyNames[i] != name) continue;
    value = trimmed(value.substr(0, value.find("!important")));
    if (!value.empty() && value != "inherit") values[i] = value;
  }
}

void Declarations::declare_all(std::string_view style) {
  while (!style.empty()) {
    auto declaration = take_until(style, ';');
    auto const name = take_until(declaration, ':');
    declare(trimmed(name), declaration);
  }
}

void Declarations::merge(Declarations const& later) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!later.values[i].empty()) values[i] = later.values[i];
  }
}

StyleSheet::StyleSheet(std::string_view css, StyleSheetLimits const& limits)
    : text_(std::make_unique<std::string const>(
          without_comments(css.substr(0, static_cast<std::size_t>(limits.max_bytes))))) {
  std::string_view text = *text_;
  while (!text.empty() && std::ssize(rules_) < limits.max_rules) {
    auto const selectors = take_until(text, '{');
    add_rule(selectors, take_until(text, '}'), limits);
  }
  is_complete_ = text.empty() && std::ssize(css) <= limits.max_bytes;
  unite_equal_selectors();
}

// One rule per selector keeps the work of apply() small however often a sheet repeats itself.
void StyleSheet::unite_equal_selectors() {
  std::sort(rules_.begin(), rules_.end(), [](Rule const& a, Rule const& b) {
    return std::tie(a.selector, a.order) < std::tie(b.selector, b.order);
  });
  std::vector<Rule> united;
  for (auto const& rule : rules_) {
    if (united.empty() || united.back().selector != rule.selector) {
      united.push_back(rule);
    } else {
      united.back().order = rule.order;
      united.back().declarations.merge(rule.declarations);
    }
  }
  rules_ = std::move(united);
}

void StyleSheet::add_rule(std::string_view selectors, std::string_view body,
                          StyleSheetLimits const& limits) {
  Declarations declarations;
  declarations.declare_all(body);
  while (!selectors.empty() && std::ssize(rules_) < limits.max_rules) {
    auto const selector = trimmed(take_until(selectors, ','));
    bool const is_simple = selector.find_first_of(" >+~:[*", 0) == std::string_view::npos &&
                           selector.find_first_of(".#", 1) == std::string_view::npos;
    if (selector.empty() || !is_simple) continue;
    rules_.push_back({selector, static_cast<int>(std::ssize(rules_)), declarations});
  }
}

void StyleSheet::collect(std::string_view selector, std::vector<Rule const*>& matches) const {
  auto const before = [](Rule const& rule, std::string_view name) { return rule.selector < name; };
  auto const rule = std::lower_bound(rules_.begin(), rules_.end(), selector, before);
  if (rule != rules_.end() && rule->selector == selector) matches.push_back(&*rule);
}

void StyleSheet::apply(std::string_view element, std::string_view classes, std::string_view id,
                       Declarations& declarations) const {
  if (rules_.empty()) return;
  auto const merge = [&](std::vector<Rule const*>& matches) {
    std::sort(matches.begin(), matches.end(),
              [](Rule const* a, Rule const* b) { return a->order < b->order; });
    for (auto const* rule : matches) declarations.merge(rule->declarations);
    matches.clear();
  };
  std::vector<Rule const*> matches;
  collect(element, matches);
  merge(matches);
  for (int i = 0; i < kClassLimit && !classes.empty(); ++i) {
    skip_separator(classes, Separator::Blank);
    auto const end = std::min(classes.find_first_of(" \t\r\n"), classes.size());
    if (end > 0) collect("." + std::string(classes.substr(0, end)), matches);
    classes.remove_prefix(end);
  }
  merge(matches);
  if (!id.empty()) collect("#" + std::string(id), matches);
  merge(matches);
}

Style cascade(Style const& parent, Declarations const& declarations, double percent_base) {
  using enum StyleProperty;
  Style style = parent;
  if (auto const colour = parse_colour(declarations[Color])) style.colour = *colour;
  set_paint(declarations[Fill], style.colour, style.fill);
  set_paint(declarations[Stroke], style.colour, style.stroke);
  set_opacity(declarations[FillOpacity], style.fill_opacity);
  set_opacity(declarations[StrokeOpacity], style.stroke_opacity);
  double own_opacity = 1;
  set_opacity(declarations[Opacity], own_opacity);
  style.opacity *= own_opacity;
  auto const width = length_px(declarations[StrokeWidth], percent_base);
  if (width && *width >= 0) style.stroke_width = *width;
  if (auto const dashes = declarations[StrokeDasharray]; !dashes.empty()) {
    style.is_dashed = is_dash_pattern(dashes);
  }
  if (auto const visibility = declarations[Visibility]; !visibility.empty()) {
    style.is_visible = visibility == "visible";
  }
  if (declarations[Display] == "none") style.is_displayed = false;
  return style;
}

Colour with_opacity(Colour colour, double opacity) {
  colour.a = static_cast<std::uint8_t>(std::round(colour.a * std::clamp(opacity, 0.0, 1.0)));
  return colour;
}

}  // namespace inkflate
