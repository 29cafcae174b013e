// SPDX-License-Identifier: Apache-2.0
#include "io/write_svg.h"

#include <gtest/gtest.h>

#include "io/bytes.h"
#include "io/read_svg.h"
#include "support/random_drawing.h"

namespace inkflate {
namespace {

TEST(WriteSvg, ReadingGivesBackEveryDrawingExactly) {
  for (int seed = 0; seed < 400; ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    auto const drawing = test::random_drawing(rng);
    auto const text = write_svg(drawing);
    auto const again = read_svg(as_bytes(text));
    ASSERT_TRUE(again.has_value()) << again.error().message << '\n' << text;
    ASSERT_EQ(*again, drawing) << text;
    ASSERT_EQ(write_svg(*again), text);
  }
}

// A layer with one outline of each kind of run: a square that starts in the middle of its ink.
Drawing square() {
  Drawing drawing;
  drawing.sketch.width_px = drawing.sketch.height_px = 300;
  drawing.sketch.strokes.push_back(
      {{{{10, 10}, 1}, {{90, 10.12345}, 0.5}}, StrokeKind::Ink, 3, {}, -1});
  Vec2 const corners[] = {{10, 10}, {90, 10}, {90, 90}, {10, 90}};
  RunKind const kinds[] = {RunKind::Ink, RunKind::HelpLine, RunKind::Closing, RunKind::Ink};
  Outline outline;
  for (int i = 0; i < 4; ++i) {
    outline.pieces.push_back({line_cubic(corners[i], corners[(i + 1) % 4]), kinds[i]});
  }
  drawing.layers.push_back({"body", {outline}, {}, {0}});
  return drawing;
}

int count(std::string const& text, std::string_view part) {
  int found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(WriteSvg, DrawsOnePathPerRun) {
  auto const text = write_svg(square());
  EXPECT_EQ(count(text, "contour ink"), 1);  // not cut at the outline's first point
  EXPECT_EQ(count(text, "contour help"), 1);
  EXPECT_EQ(count(text, "contour closing"), 1);
  EXPECT_EQ(count(text, "class=\"fill\""), 1);
  EXPECT_NE(text.find("class=\"detail\" d=\"M10 10L90 10.123\""), std::string::npos);
}

TEST(WriteSvg, ALayerIsPaintedInItsColour) {
  auto drawing = square();
  drawing.layers[0].fill = Colour{1, 2, 255, 51};
  EXPECT_EQ(count(write_svg(drawing), " fill=\"#0102ff\" fill-opacity=\"0.2\""), 1);
}

TEST(WriteSvg, RoughStrokesAreHiddenBehindLayers) {
  auto drawing = square();
  EXPECT_EQ(count(write_svg(drawing), "display:none"), 1);
  drawing.layers.clear();
  EXPECT_EQ(count(write_svg(drawing), "display:none"), 0);
}

TEST(WriteSvg, AnEmptyDrawingSurvives) {
  auto const again = read_svg(as_bytes(write_svg({})));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(*again, Drawing{});
}

TEST(WriteSvg, NamesThatXmlCannotHoldAreReplaced) {
  Drawing drawing;
  drawing.sketch.groups = {{std::string("a\x01\xff", 3)}};
  auto const again = read_svg(as_bytes(write_svg(drawing)));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->sketch.groups[0].name, "a\xef\xbf\xbd\xef\xbf\xbd");
}

TEST(WriteSvg, DamagedDrawingDataIsNamed) {
  auto drawing = square();
  drawing.layers.front().bend_pins = {{{30, 40}}, {{50, 60}, -0.5}};
  auto const text = write_svg(drawing);
  struct Case {
    std::string from;
    std::string to;
  };
  for (auto const& [from, to] : {Case{"inkflate:details=\"0\"", "inkflate:details=\"1\""},
                                 Case{"i1h1c1i1", "i1h1c1"},
                                 Case{"i1h1c1i1", "i1h1c1x1"},
                                 Case{"i1h1c1i1", "i1h1c1i999999999"},
                                 Case{"i1h1c1i1", "i1h1c1i0"},
                                 Case{"M10 10L90 10.12345", "M10 10L90 nan"},
                                 Case{"M10 10L90 10.12345", "M10 10L90 1e7"},
                                 Case{"pressure=\"1 0.5", "pressure=\"1"},
                                 Case{"stroke-width=\"3\"", "stroke-width=\"-3\""},
                                 Case{"sources=\";", "sources=\"0 1 5 0 1,;"},
                                 Case{"sources=\";", "sources=\"0 1 0.5 0 1,;"},
                                 Case{"sources=\";", "sources=\""},
                                 Case{"thickness=\"2\"", "thickness=\"0\""},
                                 Case{"thickness=\"2\"", "fill=\"none\""},
                                 Case{"width=\"300\"", "width=\"wide\""},
                                 Case{"stray=\"\"", "stray=\"-1\""},
                                 Case{"Z\"", "\""},
                                 Case{"pins=\"30 40;", "pins=\"30;"},
                                 Case{"pins=\"30 40;", "pins=\"30 1e7;"},
                                 Case{" -0.5;", " -0.5 0.5;"},
                                 Case{" -0.5;", " -0.5"},
                                 Case{" -0.5;", " inf;"}}) {
    auto damaged = text;
    auto const at = damaged.find(from);
    ASSERT_NE(at, damaged.npos) << from;
    damaged.replace(at, from.size(), to);
    auto const again = read_svg(as_bytes(damaged));
    ASSERT_FALSE(again.has_value()) << to;
    EXPECT_EQ(again.error().code, ErrorCode::BadInput);
    EXPECT_EQ(damaged[static_cast<std::size_t>(again.error().index)], '<');
  }
}

TEST(WriteSvg, WhatOtherProgramsAddIsPassedOver) {
  auto text = write_svg(square());
  auto const at = text.find("<g ");
  text.insert(at, "<sodipodi:namedview/><g id='theirs'><path d='M0 0L9 9' stroke='red'/></g>");
  auto const again = read_svg(as_bytes(text));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(*again, square());
}

TEST(WriteSvg, HiddenLayersAreNotDisplayed) {
  auto drawing = square();
  EXPECT_EQ(count(write_svg(drawing), "display:none"), 1);  // the rough strokes
  drawing.layers[0].is_hidden = true;
  EXPECT_EQ(count(write_svg(drawing), "display:none"), 2);
}

TEST(WriteSvg, ALayerWithoutOutlineShowsItsStrokes) {
  auto drawing = square();
  drawing.layers = {{"open", {}, {0}, {}}};
  auto const text = write_svg(drawing);
  EXPECT_EQ(count(text, "class=\"stroke\""), 1);
  EXPECT_EQ(*read_svg(as_bytes(text)), drawing);
}

TEST(WriteSvg, DamagedStatesAreRefused) {
  auto drawing = square();
  drawing.sketch.strokes[0].depth = StrokeDepth::Far;
  drawing.layers[0].id = LayerId{7};
  drawing.layers[0].noise = {0};
  drawing.layers[0].choice = {5, {{1, 2}}, {{3, 4}}};
  auto const text = write_svg(drawing);
  ASSERT_EQ(*read_svg(as_bytes(text)), drawing);
  struct Case {
    std::string from;
    std::string to;
  };
  for (auto const& [from, to] :
       {Case{":depth=\"far\"", ":depth=\"away\""}, Case{":id=\"7\"", ":id=\"-7\""},
        Case{":id=\"7\"", ":id=\"7.5\""}, Case{":noise=\"0\"", ":noise=\"1\""},
        Case{":gap=\"5\"", ":gap=\"0\""}, Case{":gap=\"5\"", ":gap=\"5px\""},
        Case{":gap=\"5\"", ":gap=\"\""}, Case{":outside=\"1 2 \"", ":outside=\"1\""},
        Case{":inside=\"3 4 \"", ":inside=\"3 4e7\""}}) {
    auto damaged = text;
    ASSERT_NE(damaged.find(from), damaged.npos) << from;
    damaged.replace(damaged.find(from), from.size(), to);
    EXPECT_EQ(read_svg(as_bytes(damaged)).error().code, ErrorCode::BadInput) << to;
  }
}

}  // namespace
}  // namespace inkflate
