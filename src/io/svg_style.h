// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/colour.h"

namespace inkflate {

/// The part of CSS that tells whether and how a shape's line is seen.

enum class StyleProperty {
  Color,
  Display,
  Fill,
  FillOpacity,
  Opacity,
  Stroke,
  StrokeDasharray,
  StrokeOpacity,
  StrokeWidth,
  Visibility,
};
inline constexpr int kStylePropertyCount = 10;

/// What is declared for one element, as text; empty: not declared.
struct Declarations {
  std::array<std::string_view, kStylePropertyCount> values;

  std::string_view operator[](StyleProperty property) const {
    return values[static_cast<std::size_t>(property)];
  }
  /// Later declarations win. Other properties than ours are ignored.
  void declare(std::string_view name, std::string_view value);
  /// "name: value; name: value".
  void declare_all(std::string_view style);
  void merge(Declarations const& later);
};

struct StyleSheetLimits {
  int max_bytes = 1 << 20;
  int max_rules = 10'000;
};

/// The rules of <style> elements with selectors .class, element or #id, alone or in a list; others are ignored.
class StyleSheet {
 public:
  explicit StyleSheet(std::string_view css = {}, StyleSheetLimits const& limits = {});

  /// False: a limit was reached and what lies beyond was not read.
  bool is_complete() const { return is_complete_; }

  /// Merges the rules that match, in CSS's order: by element, by class, by id, and each in the order of the sheet,
  /// where rules with one selector count as one at the place of the last. Of an element's classes 16 are looked at.
  void apply(std::string_view element, std::string_view classes, std::string_view id,
             Declarations& declarations) const;

 private:
  struct Rule {
    std::string_view selector;
    int order = 0;
    Declarations declarations;
  };
  void add_rule(std::string_view selectors, std::string_view body, StyleSheetLimits const& limits);
  void unite_equal_selectors();
  void collect(std::string_view selector, std::vector<Rule const*>& matches) const;

  std::unique_ptr<std::string const> text_;  // the rules' views point into it, also after a move
  std::vector<Rule> rules_;                  // sorted by selector, each selector once
  bool is_complete_ = true;
};

struct Paint {
  bool is_none = false;
  Colour colour;
};

/// What holds at one element after inheritance.
struct Style {
  Paint stroke = {true, {}};
  Paint fill;
  Colour colour;            // what currentColor means
  double stroke_width = 1;  // user units
  double stroke_opacity = 1;
  double fill_opacity = 1;
  double opacity = 1;  // of the element and all around it
  bool is_dashed = false;
  bool is_visible = true;
  bool is_displayed = true;
};

/// The style of an element inside another. percent_base is what 100 % of a stroke's width means.
Style cascade(Style const& parent, Declarations const& declarations, double percent_base);

/// The alpha of the paint times an opacity in 0 .. 1.
Colour with_opacity(Colour colour, double opacity);

}  // namespace inkflate
