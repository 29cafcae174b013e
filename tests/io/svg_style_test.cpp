// SPDX-License-Identifier: Apache-2.0
#include "io/svg_style.h"

#include <gtest/gtest.h>

#include "io/svg_colour.h"
#include "io/svg_units.h"

namespace inkflate {
namespace {

TEST(SvgColour, ReadsEveryNotation) {
  Colour const coral = {255, 127, 80, 255};
  for (char const* text :
       {"coral", " Coral ", "#ff7f50", "#FF7F50", "#ff7f50ff", "rgb(255,127,80)", "rgb(255 127 80)",
        "RGB( 255, 127 , 80 )", "rgba(255,127,80,1)", "rgb(255 127 80 / 100%)"}) {
    EXPECT_EQ(parse_colour(text), coral) << text;
  }
  EXPECT_EQ(parse_colour("#f80"), (Colour{255, 136, 0, 255}));
  EXPECT_EQ(parse_colour("#f808"), (Colour{255, 136, 0, 136}));
  EXPECT_EQ(parse_colour("rgb(100%, 0%, 50%)"), (Colour{255, 0, 128, 255}));
  EXPECT_EQ(parse_colour("rgba(1,2,3,0.5)"), (Colour{1, 2, 3, 128}));
  EXPECT_EQ(parse_colour("rgb(300,-5,0)"), (Colour{255, 0, 0, 255}));
  EXPECT_EQ(parse_colour("transparent")->a, 0);
  EXPECT_EQ(parse_colour("aliceblue"), (Colour{0xf0, 0xf8, 0xff, 255}));
  EXPECT_EQ(parse_colour("yellowgreen"), (Colour{0x9a, 0xcd, 0x32, 255}));
}

TEST(SvgColour, RefusesWhatIsNoColour) {
  for (char const* text : {"", "#", "#12", "#12345", "#ggg", "rgb(1,2)", "rgb(1,2,3",
                           "rgb(1,2,3,4,5)", "blurple", "rgb(nan,0,0)", "rgb(1e999,0,0)"}) {
    EXPECT_EQ(parse_colour(text), std::nullopt) << text;
  }
}

TEST(SvgUnits, LengthsBecomePixels) {
  struct Case {
    char const* text;
    double px;
  };
  for (auto const& [text, px] :
       {Case{"10", 10}, Case{"10px", 10}, Case{"1in", 96}, Case{"25.4mm", 96}, Case{"2.54cm", 96},
        Case{"72pt", 96}, Case{"6pc", 96}, Case{"50%", 100}, Case{"2em", 32}, Case{" -3 ", -3},
        Case{"1e1PX", 10}}) {
    EXPECT_NEAR(length_px(text, 200).value(), px, 1e-12) << text;
  }
  for (char const* text : {"", "px", "3furlongs", "1e999", "auto"}) {
    EXPECT_EQ(length_px(text, 200), std::nullopt) << text;
  }
}

void expect_maps(char const* transform, Vec2 from, Vec2 to) {
  auto const map = parse_transform(transform);
  ASSERT_TRUE(map.has_value()) << transform;
  EXPECT_LT(distance((*map)(from), to), 1e-12) << transform;
}

TEST(SvgUnits, EveryTransformFunctionMapsAsSvgSays) {
  expect_maps("", {3, 4}, {3, 4});
  expect_maps("matrix(1 2 3 4 5 6)", {1, 1}, {9, 12});
  expect_maps("translate(5)", {1, 1}, {6, 1});
  expect_maps("translate(5,-2)", {1, 1}, {6, -1});
  expect_maps("scale(2)", {1, 3}, {2, 6});
  expect_maps("scale(2 -1)", {1, 3}, {2, -3});
  expect_maps("rotate(90)", {1, 0}, {0, 1});
  expect_maps("rotate(-270 5 5)", {6, 5}, {5, 6});
  expect_maps("rotate(3690)", {1, 0}, {0, 1});
  expect_maps("skewX(45)", {0, 2}, {2, 2});
  expect_maps("skewY(45)", {2, 0}, {2, 2});
  expect_maps("translate(10,0) scale(2), rotate(90)", {1, 0}, {10, 2});
}

TEST(SvgUnits, DamagedTransformsAreRefused) {
  for (char const* text : {"translate", "translate(", "translate(1,2,3)", "matrix(1 2 3)",
                           "spin(5)", "scale(1e999)", "rotate(1 2)", "translate(1) junk"}) {
    EXPECT_EQ(parse_transform(text), std::nullopt) << text;
  }
}

TEST(SvgUnits, ViewBoxIsFittedAsAsked) {
  ViewBox const box = {{10, 20}, {100, 50}};
  struct Case {
    char const* ratio;
    Vec2 at_min;
    double scale;
  };
  for (auto const& [ratio, at_min, scale] :
       {Case{"", {0, 50}, 2}, Case{"xMidYMid meet", {0, 50}, 2}, Case{"xMinYMin", {0, 0}, 2},
        Case{"xMaxYMax", {0, 100}, 2}, Case{"xMidYMid slice", {-100, 0}, 4},
        Case{"xMinYMax slice", {0, 0}, 4}, Case{"xMaxYMin slice", {-200, 0}, 4}}) {
    auto const map = fit_view_box(box, {200, 200}, ratio);
    EXPECT_EQ(map(box.min), at_min) << ratio;
    EXPECT_EQ(map.mean_scale(), scale) << ratio;
  }
  auto const stretched = fit_view_box(box, {200, 200}, "none");
  EXPECT_EQ(stretched({110, 70}), (Vec2{200, 200}));
}

TEST(SvgUnits, ViewBoxNeedsFourNumbersAndASize) {
  EXPECT_TRUE(parse_view_box(" 0,0 , 10 10 ").has_value());
  for (char const* text : {"", "0 0 10", "0 0 0 10", "0 0 10 -1", "0 0 nan 1", "0 0 1e999 1"}) {
    EXPECT_FALSE(parse_view_box(text).has_value()) << text;
  }
}

Style styled(std::string_view declarations, Style const& parent = {}) {
  Declarations declared;
  declared.declare_all(declarations);
  return cascade(parent, declared, 100);
}

TEST(SvgStyle, InheritsWhatIsNotDeclared) {
  auto const parent =
      styled("stroke: red; stroke-width:3; opacity:.5; fill:none; stroke-dasharray:4 2");
  auto const child = styled("opacity: 50%", parent);
  EXPECT_EQ(child.stroke.colour, (Colour{255, 0, 0, 255}));
  EXPECT_EQ(child.stroke_width, 3);
  EXPECT_TRUE(child.fill.is_none);
  EXPECT_TRUE(child.is_dashed);
  EXPECT_EQ(child.opacity, 0.25);
}

TEST(SvgStyle, UnderstandsSpecialPaints) {
  EXPECT_EQ(styled("color:blue;stroke:currentColor").stroke.colour, (Colour{0, 0, 255, 255}));
  EXPECT_FALSE(styled("stroke:url(#gradient)").stroke.is_none);
  EXPECT_EQ(styled("stroke:url(#gradient) lime").stroke.colour, (Colour{0, 255, 0, 255}));
  EXPECT_TRUE(styled("stroke:red;stroke:none").stroke.is_none);
  EXPECT_EQ(styled("stroke:red;stroke:nonsense", styled("stroke:blue")).stroke.colour,
            styled("stroke:blue").stroke.colour);
}

TEST(SvgStyle, DashesNeedALength) {
  EXPECT_TRUE(styled("stroke-dasharray:5,5").is_dashed);
  EXPECT_TRUE(styled("stroke-dasharray:0 2px").is_dashed);
  EXPECT_FALSE(styled("stroke-dasharray:none", styled("stroke-dasharray:5")).is_dashed);
  EXPECT_FALSE(styled("stroke-dasharray:0").is_dashed);
  EXPECT_FALSE(styled("stroke-dasharray:0px 0px").is_dashed);
}

TEST(SvgStyle, SheetsApplyByElementThenClassThenId) {
  StyleSheet const sheet(
      "/* a { } */ @charset x; path{stroke:red;fill:red;color:red}\n"
      ".a,.b{stroke:lime;fill:lime} .b{fill:blue !important} #c{fill:white} .a .b{fill:none} .a{}");
  EXPECT_TRUE(sheet.is_complete());
  auto const fill = [&](char const* element, char const* classes, char const* id) {
    Declarations declared;
    sheet.apply(element, classes, id, declared);
    return std::string(declared[StyleProperty::Fill]);
  };
  EXPECT_EQ(fill("path", "", ""), "");  // the unknown rule in front took it along
  EXPECT_EQ(fill("rect", "x a", ""), "lime");
  EXPECT_EQ(fill("rect", "b a", ""), "lime");  // the later rule of .a counts for all of them
  EXPECT_EQ(fill("rect", " b ", ""), "blue");
  EXPECT_EQ(fill("rect", "b", "c"), "white");
}

TEST(SvgStyle, SheetsBeyondTheLimitsAreCut) {
  StyleSheetLimits limits;
  limits.max_rules = 2;
  EXPECT_FALSE(StyleSheet(".a{}.b{}.c{}", limits).is_complete());
  limits = {};
  limits.max_bytes = 5;
  EXPECT_FALSE(StyleSheet(".a{fill:red}", limits).is_complete());
}

}  // namespace
}  // namespace inkflate
