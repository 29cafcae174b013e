// SPDX-License-Identifier: Apache-2.0
#include "io/read_svg.h"

#include <gtest/gtest.h>

#include "geometry/polyline.h"
#include "geometry/trig.h"
#include "io/bytes.h"

namespace inkflate {
namespace {

constexpr char kPen[] = "fill='none' stroke='black'";

SvgReading read(std::string const& document) {
  auto reading = read_svg_with_warnings(as_bytes(document));
  EXPECT_TRUE(reading.has_value()) << document.substr(0, 500);
  return reading ? *reading : SvgReading{};
}

// The sketch of a body on a canvas of 100 x 100 where lines are black unless they say otherwise.
Sketch sketch_of(std::string const& body) {
  return read("<svg width='100' height='100' " + std::string(kPen) + ">" + body + "</svg>")
      .drawing.sketch;
}

Polyline points_of(Stroke const& stroke) {
  Polyline points;
  for (auto const& sample : stroke.samples) points.push_back(sample.position);
  return points;
}

std::vector<Polyline> lines_of(std::string const& body) {
  std::vector<Polyline> lines;
  for (auto const& stroke : sketch_of(body).strokes) lines.push_back(points_of(stroke));
  return lines;
}

Polyline const kDiagonal = {{1, 2}, {3, 4}};
std::string const kLine = "<line x1='1' y1='2' x2='3' y2='4'/>";

std::string reasons(SvgReading const& reading) {
  std::string text;
  for (auto const& warning : reading.warnings) {
    text += warning.reason + " x" + std::to_string(warning.count) + ";";
  }
  return text;
}

TEST(ReadSvg, ReadsEveryStraightShape) {
  EXPECT_EQ(lines_of(kLine), std::vector<Polyline>(1, kDiagonal));
  EXPECT_EQ(lines_of("<polyline points='1,2 3,4'/>"), std::vector<Polyline>(1, kDiagonal));
  EXPECT_EQ(lines_of("<path d='M1 2L3 4'/>"), std::vector<Polyline>(1, kDiagonal));
  EXPECT_EQ(lines_of("<polygon points='1 2 3 4 5 0'/>"),
            (std::vector<Polyline>{{{1, 2}, {3, 4}, {5, 0}, {1, 2}}}));
  EXPECT_EQ(lines_of("<rect x='1' y='2' width='10' height='20'/>"),
            (std::vector<Polyline>{{{1, 2}, {11, 2}, {11, 22}, {1, 22}, {1, 2}}}));
}

TEST(ReadSvg, ReadsRoundShapes) {
  auto const circle = lines_of("<circle cx='50' cy='40' r='30'/>");
  ASSERT_EQ(circle.size(), 1U);
  EXPECT_EQ(circle[0].front(), circle[0].back());
  for (auto const p : circle[0]) EXPECT_NEAR(distance(p, {50, 40}), 30, 2e-4);
  EXPECT_NEAR(signed_area(circle[0]), kPi * 900, 13);
  auto const ellipse = lines_of("<ellipse cx='50' cy='40' rx='30' ry='10'/>");
  for (auto const p : ellipse.at(0)) {
    EXPECT_NEAR((p.x - 50) * (p.x - 50) / 900 + (p.y - 40) * (p.y - 40) / 100, 1, 2e-5);
  }
  auto const rect = lines_of("<rect width='60' height='40' rx='10'/>");
  EXPECT_NEAR(signed_area(rect.at(0)), 60 * 40 - (4 - kPi) * 100, 4);
  auto const pill = lines_of("<rect width='60' height='40' rx='99' ry='5'/>");
  EXPECT_EQ(bounds(pill.at(0)).max, (Vec2{60, 40}));
}

TEST(ReadSvg, ShapesWithoutSizeDrawNothing) {
  EXPECT_TRUE(lines_of("<rect width='5'/><circle/><ellipse rx='0' ry='3'/><path/><path d=''/>"
                       "<polyline/><polygon points='1 1'/><rect width='-5' height='5'/>")
                  .size() <= 1);
}

TEST(ReadSvg, EverySubpathIsAStroke) {
  EXPECT_EQ(lines_of("<path d='M1 2L3 4M0 0L5 5z'/>"),
            (std::vector<Polyline>{kDiagonal, {{0, 0}, {5, 5}, {0, 0}}}));
}

TEST(ReadSvg, KeepsOrderColourAndWidth) {
  auto const sketch = sketch_of(
      "<path d='M0 0L9 0' stroke='red' stroke-width='3'/>"
      "<g transform='scale(2)' style='stroke:#00f;stroke-opacity:.5'><path d='M0 1L9 1'/></g>");
  ASSERT_EQ(sketch.strokes.size(), 2U);
  EXPECT_EQ(sketch.strokes[0].colour, (Colour{255, 0, 0, 255}));
  EXPECT_EQ(sketch.strokes[0].width_px, 3);
  EXPECT_EQ(sketch.strokes[0].samples[1].pressure, 1);
  EXPECT_EQ(sketch.strokes[1].colour, (Colour{0, 0, 255, 128}));
  EXPECT_EQ(sketch.strokes[1].width_px, 2);
}

TEST(ReadSvg, TransformsNest) {
  EXPECT_EQ(lines_of("<g transform='translate(10,20)'><g transform='scale(2)'>"
                     "<line x1='1' y1='2' x2='3' y2='4' transform='translate(1)'/></g></g>"),
            (std::vector<Polyline>{{{14, 24}, {18, 28}}}));
}

TEST(ReadSvg, CurvesAreSampledFinelyOnTheCanvas) {
  auto const small = lines_of("<circle r='1'/>").at(0).size();
  auto const large = lines_of("<circle r='1' transform='scale(400)'/>").at(0).size();
  EXPECT_GT(large, 8 * small);
}

TEST(ReadSvg, TakesTheCanvasFromSizeAndViewBox) {
  struct Case {
    char const* attributes;
    Vec2 size;
    Vec2 first;  // where (1, 2) lands
  };
  for (auto const& [attributes, size, first] : {
           Case{"width='50' height='40'", {50, 40}, {1, 2}},
           Case{"viewBox='0 0 50 40'", {50, 40}, {1, 2}},
           Case{"viewBox='0 0 50 40' width='100'", {100, 80}, {2, 4}},
           Case{"viewBox='0 0 50 40' height='100%'", {50, 40}, {1, 2}},
           Case{"viewBox='-10 -10 20 20' width='200' height='200'", {200, 200}, {110, 120}},
           Case{"viewBox='0 0 10 10' width='200' height='100'", {200, 100}, {60, 20}},
           Case{"viewBox='0 0 10 10' width='20' height='50' preserveAspectRatio='none'",
                {20, 50},
                {2, 10}},
           Case{"width='1in' height='2in'", {96, 192}, {1, 2}},
           Case{"width='-5' height='nan' viewBox='0 0 50 40'", {50, 40}, {1, 2}},
           Case{"", {3, 4}, {1, 2}},  // nothing said: what the strokes need
       }) {
    auto const sketch =
        read("<svg " + std::string(attributes) + " stroke='red'>" + kLine + "</svg>")
            .drawing.sketch;
    EXPECT_EQ((Vec2{sketch.width_px, sketch.height_px}), size) << attributes;
    ASSERT_EQ(sketch.strokes.size(), 1U) << attributes;
    EXPECT_LT(distance(sketch.strokes[0].samples[0].position, first), 1e-12) << attributes;
  }
}

TEST(ReadSvg, NestedViewportsPlaceAndScale) {
  EXPECT_EQ(
      lines_of("<svg x='10' y='20' width='40' height='40' viewBox='0 0 20 20'>" + kLine + "</svg>"),
      (std::vector<Polyline>{{{12, 24}, {16, 28}}}));
  EXPECT_EQ(lines_of("<svg x='50%' width='0' height='5'>" + kLine + "</svg>").size(), 0U);
  EXPECT_EQ(lines_of("<svg width='50%' height='50%'><line x2='100%'/></svg>"),
            (std::vector<Polyline>{{{0, 0}, {50, 0}}}));
}

TEST(ReadSvg, UsePlacesItsTarget) {
  std::string const defs = "<defs><g id='pair'>" + kLine + kLine +
                           "</g><symbol id='s' viewBox='0 0 10 10'>" + kLine +
                           "</symbol><line id='l' x1='1' y1='2' x2='3' y2='4'/></defs>";
  EXPECT_EQ(lines_of(defs), std::vector<Polyline>{});
  EXPECT_EQ(lines_of(defs + "<use href='#l' x='10' y='20'/>"),
            (std::vector<Polyline>{{{11, 22}, {13, 24}}}));
  EXPECT_EQ(lines_of(defs + "<use xlink:href='#pair' transform='scale(2)'/>"),
            (std::vector<Polyline>{{{2, 4}, {6, 8}}, {{2, 4}, {6, 8}}}));
  EXPECT_EQ(lines_of(defs + "<use href='#s' x='5' width='20' height='20'/>"),
            (std::vector<Polyline>{{{7, 4}, {11, 8}}}));
  EXPECT_EQ(sketch_of(defs + "<use href='#l' stroke='red'/>").strokes.at(0).colour,
            (Colour{255, 0, 0, 255}));
}

TEST(ReadSvg, DefinitionsAndForeignElementsAreNotDrawn) {
  for (std::string const name :
       {"defs", "symbol", "clipPath", "mask", "marker", "pattern", "metadata", "script", "title",
        "x:g", "unknown", "filter", "foreignObject"}) {
    std::string body = "<" + name + ">";
    body += kLine;
    body += "</" + name + ">";
    EXPECT_EQ(lines_of(body).size(), 0U) << name;
  }
  EXPECT_EQ(lines_of("<a>" + kLine + "</a><switch>" + kLine + "</switch>").size(), 2U);
}

TEST(ReadSvg, InvisibleShapesAreSkipped) {
  for (char const* attributes :
       {"display='none'", "style='display:none'", "visibility='hidden'", "visibility='collapse'",
        "stroke='none'", "opacity='0'", "stroke-opacity='0'", "stroke-width='0'",
        "stroke='transparent'", "stroke='rgba(1,2,3,0)'", "transform='scale(0)'"}) {
    EXPECT_EQ(lines_of("<line x2='9' " + std::string(attributes) + "/>").size(), 0U) << attributes;
  }
  EXPECT_EQ(lines_of("<g visibility='hidden'><line x2='9' visibility='visible'/></g>").size(), 1U);
  EXPECT_EQ(lines_of("<g display='none'><line x2='9' display='inline'/></g>").size(), 0U);
}

TEST(ReadSvg, FilledShapesComeAsTheirOutline) {
  auto const sketch =
      sketch_of("<path d='M0 0L20 0L20 20' stroke='none' fill='#ff0000' fill-opacity='.5'/>");
  ASSERT_EQ(sketch.strokes.size(), 1U);
  EXPECT_EQ(points_of(sketch.strokes[0]), (Polyline{{0, 0}, {20, 0}, {20, 20}, {0, 0}}));
  EXPECT_EQ(sketch.strokes[0].width_px, 1);
  EXPECT_EQ(sketch.strokes[0].colour, (Colour{255, 0, 0, 128}));
  EXPECT_EQ(lines_of("<line x2='9' fill='red' stroke='none'/>").size(), 0U);
  EXPECT_EQ(lines_of("<path d='M0 0L9 9' fill='red' stroke='none'/>").size(), 0U);
}

TEST(ReadSvg, TheFilledPaperIsNotDrawn) {
  auto const reading = read(
      "<svg width='100' height='50'><rect width='100%' height='100%' fill='white'/>"
      "<path d='M0 0H50V50z'/></svg>");
  EXPECT_EQ(reading.drawing.sketch.strokes.size(), 1U);
  EXPECT_EQ(reasons(reading), "a background that fills the canvas x1;");
}

TEST(ReadSvg, ReadsClassesOfStyleSheets) {
  auto const sketch =
      read(
          "<svg width='9' height='9'><defs><style>.cls-1{fill:none;stroke:#f00;stroke-width:4px}"
          "</style></defs><path class='x cls-1' d='M0 0L9 9'/></svg>")
          .drawing.sketch;
  ASSERT_EQ(sketch.strokes.size(), 1U);
  EXPECT_EQ(sketch.strokes[0].width_px, 4);
  EXPECT_EQ(sketch.strokes[0].colour, (Colour{255, 0, 0, 255}));
  EXPECT_EQ(sketch_of("<style><![CDATA[.a{stroke:blue}]]></style><g class='a' stroke='red'>"
                      "<line x2='1' style='stroke:lime'/><line x2='1'/></g>")
                .strokes.at(1)
                .colour,
            (Colour{0, 0, 255, 255}));
}

TEST(ReadSvg, KnowsHelpLines) {
  for (char const* body :
       {"<line x2='9' class='help'/>", "<line x2='9' class='a Help-line'/>",
        "<line x2='9' stroke-dasharray='4 2'/>", "<g id='help'><line x2='9'/></g>",
        "<g inkscape:label='Help lines'><g id='g12'><line x2='9'/></g></g>",
        "<g class='help'><line x2='9'/></g>"}) {
    auto const sketch = sketch_of(body);
    ASSERT_EQ(sketch.strokes.size(), 1U) << body;
    EXPECT_EQ(sketch.strokes[0].kind, StrokeKind::HelpLine) << body;
    EXPECT_TRUE(sketch.groups.empty() || sketch.groups[0].name == "g12") << body;
  }
  for (char const* body :
       {"<line x2='9' class='whelp'/>", "<line x2='9' stroke-dasharray='none'/>",
        "<g inkscape:label='help'><g inkscape:label='head'><line x2='9'/></g></g>"}) {
    EXPECT_EQ(sketch_of(body).strokes.at(0).kind, StrokeKind::Ink) << body;
  }
}

std::string groups_of(std::string const& body) {
  auto const sketch = sketch_of(body);
  std::string text;
  for (auto const& group : sketch.groups) text += group.name + ";";
  for (auto const& stroke : sketch.strokes) text += " " + std::to_string(stroke.group);
  return text;
}

TEST(ReadSvg, TopLevelGroupsAreCandidateLayers) {
  EXPECT_EQ(groups_of(kLine + "<g>" + kLine + "</g><g/><g><g>" + kLine + "</g>" + kLine + "</g>"),
            "group 1;group 2; -1 0 1 1");
  EXPECT_EQ(groups_of("<g id='a'>" + kLine + "</g><g>" + kLine +
                      "</g><g id='b' inkscape:label='B &amp; c'>" + kLine + "</g>"),
            "a;B & c; 0 -1 1");
  EXPECT_EQ(groups_of("<g inkscape:groupmode='layer'>" + kLine + "</g>"), "group 1; 0");
  EXPECT_EQ(groups_of("<g>" + kLine + "</g><g id='help'>" + kLine + "</g>"), "group 1; 0 -1");
  EXPECT_EQ(groups_of("<g id='a'>" + kLine + "</g><g id='helplines'>" + kLine + "</g>"), "a; 0 -1");
}

TEST(ReadSvg, GroupsSayHowTheirLayerShallLook) {
  auto const reading = read(
      "<svg stroke='red'><g id='leg' data-fill=' #a0B1c2 ' data-thickness='4.5'><line x2='9'/></g>"
      "<g id='arm' data-fill='spotted' data-thickness='99'><line x2='9'/></g></svg>");
  auto const& groups = reading.drawing.sketch.groups;
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0], (StrokeGroup{"leg", Colour{0xa0, 0xb1, 0xc2}, 4.5}));
  EXPECT_EQ(groups[1], StrokeGroup{"arm"});
  EXPECT_EQ(reasons(reading),
            "a data-fill that is no colour x1;a data-thickness that is not within 0.1 .. 32 x1;");
}

TEST(ReadSvg, AGroupMayBeACopyOfAnother) {
  auto const sketch =
      sketch_of("<g id='far-leg' data-fill='#123456'><use href='#leg' x='5'/></g><g id='leg'>" +
                kLine + "</g>");
  ASSERT_EQ(sketch.groups.size(), 2U);
  EXPECT_EQ(sketch.groups[0].name, "far-leg");
  EXPECT_TRUE(sketch.groups[0].fill.has_value());
  EXPECT_EQ(sketch.groups[1], StrokeGroup{"leg"});
  ASSERT_EQ(sketch.strokes.size(), 2U);
  EXPECT_EQ(sketch.strokes[0].group, 0);
  EXPECT_EQ(sketch.strokes[1].group, 1);
  EXPECT_EQ(sketch.strokes[0].samples[0].position,
            sketch.strokes[1].samples[0].position + (Vec2{5, 0}));
}

TEST(ReadSvg, PrefixedDocumentsAreTheSame) {
  auto const sketch =
      read(
          "<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:line x2='9' stroke='red'/>"
          "<line x2='9' stroke='red'/></s:svg>")
          .drawing.sketch;
  EXPECT_EQ(sketch.strokes.size(), 1U);
}

TEST(ReadSvg, WhatIsLeftOutIsTold) {
  auto const reading = read(
      "<svg width='9' height='9' stroke='red' fill='none'><text>hi</text><image/><line x2='1e7'/>"
      "<line x2='1e7'/><path d='M0 0L1 1 junk'/><line x2='1' transform='spin(3)'/></svg>");
  EXPECT_EQ(reasons(reading),
            "text or a picture, which is not a line x2;a coordinate beyond 1e6 px x2;"
            "damaged data, read up to the damage x1;a transform that cannot be read and was left "
            "out x1;");
  EXPECT_EQ(reading.warnings[1].first_byte, 74);
  EXPECT_EQ(reading.drawing.sketch.strokes.size(), 2U);
}

TEST(ReadSvg, AGroupAroundAllGroupsIsNoLayer) {
  std::string const text =
      "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><g stroke='red' "
      "fill='none'>"
      "<g id='ear'><path d='M0,0 L9,9'/></g><g id='tail'><path d='M5,0 L9,9'/></g></g></svg>";
  auto const drawing = read_svg(std::as_bytes(std::span(text)));
  ASSERT_TRUE(drawing.has_value());
  EXPECT_EQ(drawing->sketch.groups, (std::vector<StrokeGroup>{{"ear"}, {"tail"}}));
  EXPECT_EQ(drawing->sketch.strokes[1].group, 1);
}

TEST(ReadSvg, ANamedGroupAloneInOneWithoutANameIsTheLayer) {
  auto const in = [](std::string const& around, std::string const& inside) {
    return groups_of("<g " + around + ">" + inside + "</g>");
  };
  std::string const fish = "<g id='fish'>" + kLine + "</g>";
  EXPECT_EQ(in("fill='none'", fish), "fish; 0");
  EXPECT_EQ(in("data-thickness='3'", fish), "group 1; 0");
  EXPECT_EQ(in("id='pond'", fish), "pond; 0");
  EXPECT_EQ(in("fill='none'", kLine + fish), "group 1; 0 0");
  EXPECT_EQ(in("fill='none'", "<g>" + kLine + "</g>"), "group 1; 0");
}

}  // namespace
}  // namespace inkflate
