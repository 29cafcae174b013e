// SPDX-License-Identifier: Apache-2.0
#include "io/write_svg.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "io/bytes.h"
#include "io/read_svg.h"

namespace inkflate {
namespace {

Vec2 random_point(Rng& rng) {
  // Whole, short and full-length numbers, also near the limit.
  int const form = rng.below(4);
  Vec2 const point = {rng.uniform(-1000, 2000), rng.uniform(-1000, 2000)};
  if (form == 0) return {std::round(point.x), std::round(point.y)};
  if (form == 1) return point * 500;
  return form == 2 ? point / 1e9 : point;
}

std::string random_name(Rng& rng) {
  char const* const parts[] = {"arm",
                               " ",
                               "<",
                               ">",
                               "&",
                               "\"",
                               "'",
                               "&amp;",
                               "\xc4\x8d",
                               "]]>",
                               "\n",
                               "\t",
                               "\xf0\x9f\x90\x99",
                               "-->"};
  std::string name;
  for (int i = rng.below(6); i > 0; --i) name += parts[rng.below(14)];
  return name;
}

Colour random_colour(Rng& rng) {
  Colour colour;
  for (auto* channel : {&colour.r, &colour.g, &colour.b, &colour.a}) {
    *channel = static_cast<std::uint8_t>(rng.below(256));
  }
  return colour;
}

Stroke random_stroke(Rng& rng, int group_count) {
  Stroke stroke;
  bool const has_pressure = rng.below(2) == 0;
  bool const has_time = rng.below(2) == 0;
  for (int i = rng.below(6); i > 0; --i) {
    stroke.samples.push_back(
        {random_point(rng), has_pressure ? rng.uniform() : 1, has_time ? rng.uniform(0, 60) : 0});
  }
  stroke.kind = rng.below(3) == 0 ? StrokeKind::HelpLine : StrokeKind::Ink;
  stroke.width_px = rng.uniform(0, 9);
  stroke.colour = random_colour(rng);
  stroke.group = rng.below(group_count + 1) - 1;
  return stroke;
}

Outline random_outline(Rng& rng, int stroke_count) {
  Outline outline;
  int const count = 1 + rng.below(6);
  Vec2 const start = random_point(rng);
  Vec2 position = start;
  for (int i = 0; i < count; ++i) {
    Vec2 const end = i + 1 < count ? random_point(rng) : start;
    outline.pieces.push_back({{{position, random_point(rng), random_point(rng), end}},
                              static_cast<RunKind>(rng.below(3))});
    position = end;
  }
  for (int i = rng.below(4); i > 0 && stroke_count > 0; --i) {
    outline.sources.push_back({rng.uniform(0, 3), rng.uniform(3, 6),
                               rng.below(stroke_count + 1) - 1, rng.uniform(0, 99),
                               rng.uniform(0, 99)});
  }
  return outline;
}

Drawing random_drawing(Rng& rng) {
  Drawing drawing;
  auto& sketch = drawing.sketch;
  sketch.width_px = rng.uniform(0, 2000);
  sketch.height_px = rng.below(2000);
  for (int i = rng.below(3); i > 0; --i) {
    sketch.groups.push_back({random_name(rng)});
    if (rng.below(2) == 0) sketch.groups.back().fill = random_colour(rng);
    if (rng.below(2) == 0) sketch.groups.back().thickness = rng.uniform(0.1, 32);
  }
  int const stroke_count = rng.below(12);
  int const group_count = static_cast<int>(sketch.groups.size());
  drawing.layers.resize(static_cast<std::size_t>(rng.below(4)));
  for (auto& layer : drawing.layers) {
    layer.name = random_name(rng);
    if (rng.below(2) == 0) layer.fill = random_colour(rng);
    if (rng.below(2) == 0) layer.thickness = rng.uniform(0.1, 32);
    for (int i = rng.below(4); i > 0; --i)
      layer.outlines.push_back(random_outline(rng, stroke_count));
  }
  for (int i = 0; i < stroke_count; ++i) {
    sketch.strokes.push_back(random_stroke(rng, group_count));
    int const place = rng.below(1 + 2 * static_cast<int>(drawing.layers.size()));
    if (place == 0) {
      drawing.stray.push_back(i);
    } else {
      auto& layer = drawing.layers[static_cast<std::size_t>((place - 1) / 2)];
      (place % 2 == 0 ? layer.details : layer.strokes).push_back(i);
    }
  }
  return drawing;
}

TEST(WriteSvg, ReadingGivesBackEveryDrawingExactly) {
  for (int seed = 0; seed < 400; ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    auto const drawing = random_drawing(rng);
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
  auto const text = write_svg(square());
  struct Case {
    std::string from;
    std::string to;
  };
  for (auto const& [from, to] :
       {Case{"inkflate:details=\"0\"", "inkflate:details=\"1\""}, Case{"i1h1c1i1", "i1h1c1"},
        Case{"i1h1c1i1", "i1h1c1x1"}, Case{"i1h1c1i1", "i1h1c1i999999999"},
        Case{"i1h1c1i1", "i1h1c1i0"}, Case{"M10 10L90 10.12345", "M10 10L90 nan"},
        Case{"M10 10L90 10.12345", "M10 10L90 1e7"}, Case{"pressure=\"1 0.5", "pressure=\"1"},
        Case{"stroke-width=\"3\"", "stroke-width=\"-3\""},
        Case{"sources=\";", "sources=\"0 1 5 0 1,;"},
        Case{"sources=\";", "sources=\"0 1 0.5 0 1,;"}, Case{"sources=\";", "sources=\""},
        Case{"thickness=\"2\"", "thickness=\"0\""}, Case{"thickness=\"2\"", "fill=\"none\""},
        Case{"width=\"300\"", "width=\"wide\""}, Case{"stray=\"\"", "stray=\"-1\""},
        Case{"Z\"", "\""}}) {
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

}  // namespace
}  // namespace inkflate
