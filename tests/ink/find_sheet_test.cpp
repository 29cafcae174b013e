// SPDX-License-Identifier: Apache-2.0
#include "ink/find_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polyline.h"
#include "ink/trace_scan.h"
#include "render/rasterise.h"
#include "support/paper.h"

namespace inkflate {
namespace {

constexpr Colour kPaper = {240, 236, 225};
constexpr Colour kInk = {50, 50, 56};
constexpr Colour kWood = {95, 70, 48};
constexpr int kWidth = 600;
constexpr int kHeight = 450;
/// 1.5 % of the longer side, and two cells.
constexpr double kMarginPx = 9 + 6;

Contour box(double left, double top, double right, double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

Contour turned(Contour points, double sine) {
  double const cosine = std::sqrt(1 - sine * sine);
  for (auto& p : points) {
    Vec2 const q = p - Vec2{kWidth / 2.0, kHeight / 2.0};
    p = Vec2{cosine * q.x - sine * q.y + kWidth / 2.0, sine * q.x + cosine * q.y + kHeight / 2.0};
  }
  return points;
}

Polyline ring(Vec2 centre, double radius_px) {
  Polyline points;
  for (int i = 0; i <= 60; ++i) {
    double const angle_rad = 2 * M_PI * i / 60;
    points.push_back(centre + radius_px * Vec2{std::cos(angle_rad), std::sin(angle_rad)});
  }
  return points;
}

StrokedPolyline line(Polyline points, double width_px = 4, Colour colour = kInk) {
  return {std::move(points), {width_px}, {}, colour};
}

Picture on_table(Contour const& sheet, Colour table = kWood, Colour paper = kPaper) {
  return rasterise({FilledPath{{sheet}, paper}, line(ring({300, 220}, 90))}, kWidth, kHeight,
                   table);
}

long long count_outside(Picture const& picture) {
  auto const sheet = find_sheet(picture);
  return std::count(sheet.values.begin(), sheet.values.end(), 0);
}

/// Nothing but the ring, and all of it.
void expect_ring_only(Picture const& picture) {
  auto const sketch = trace_scan(picture);
  ASSERT_TRUE(sketch.has_value()) << sketch.error().message;
  ASSERT_EQ(sketch->strokes.size(), 1U);
  auto const& samples = sketch->strokes[0].samples;
  EXPECT_EQ(samples.front().position, samples.back().position);
  for (auto const& sample : samples) {
    EXPECT_NEAR(distance(sample.position, {300, 220}), 90, 1.5);
  }
}

TEST(FindSheet, ATurnedSheetOnATableEndsWithinItsEdge) {
  for (double const sine : {-0.12, -0.03, 0.0, 0.05, 0.1}) {
    SCOPED_TRACE(sine);
    auto const outline = turned(box(90, 70, 520, 390), sine);
    auto const photo = test::photographed(on_table(outline), 8, 1);
    auto const sheet = find_sheet(photo);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        double inside_px = 1e9;
        for (std::size_t i = 0; i < outline.size(); ++i) {
          Vec2 const from = outline[i];
          Vec2 const along = normalized(outline[(i + 1) % outline.size()] - from);
          inside_px = std::min(inside_px, cross(along, Vec2{x + 0.5, y + 0.5} - from));
        }
        if (inside_px > 3 && inside_px < kMarginPx + 3) continue;
        ASSERT_EQ(sheet.at(x, y), inside_px > 3 ? 255 : 0) << x << " " << y;
      }
    }
    expect_ring_only(photo);
  }
}

TEST(FindSheet, ATableOnOneOrTwoSidesGivesNoStrokes) {
  expect_ring_only(on_table(box(70, -10, 610, 460)));
  expect_ring_only(on_table(box(-10, -10, 610, 400)));
  expect_ring_only(on_table(box(-10, 40, 540, 460)));
  // A wedge: the sheet's edge leaves the picture.
  expect_ring_only(on_table({{-10, -10}, {610, -10}, {610, 400}, {-10, 465}}));
}

TEST(FindSheet, AWhiteGroundAroundAGreySheetGivesNoStrokes) {
  auto const picture = on_table(box(60, 50, 540, 400), {255, 255, 255}, {222, 220, 214});
  EXPECT_GT(count_outside(picture), 0);
  expect_ring_only(picture);
}

TEST(FindSheet, ASheetSmallerThanItsBlackTableIsNotADrawingOnBlack) {
  expect_ring_only(on_table(box(180, 110, 420, 330), {10, 10, 10}));
}

TEST(FindSheet, APageThatFillsThePictureIsAllSheet) {
  EXPECT_EQ(count_outside(test::photographed(on_table(box(-10, -10, 610, 460)), 8, 2)), 0);
  EXPECT_EQ(count_outside(Picture(1, 1, kPaper)), 0);
  EXPECT_EQ(count_outside(Picture(kWidth, 3, kPaper)), 0);
  EXPECT_EQ(count_outside(Picture(kWidth, kHeight, kInk)), 0);
}

TEST(FindSheet, InkThatTouchesTheBorderStays) {
  DrawList list = {line({{-5, 120}, {200, 160}}), line({{500, -5}, {470, 455}}),
                   line({{-5, 440}, {605, 435}}), line({{15, 15}, {585, 15}, {585, 200}})};
  list.push_back(FilledPath{{box(200, 300, 420, 460)}, kInk});
  auto const picture = rasterise(list, kWidth, kHeight, kPaper);
  EXPECT_EQ(count_outside(picture), 0);
}

TEST(FindSheet, AHillColouredDownToTheBorderStays) {
  Contour hill = {{605, 455}, {-5, 455}};
  for (int x = -5; x <= 605; x += 10)
    hill.push_back({x + 0.0, 340 + 0.0006 * (x - 280) * (x - 280)});
  EXPECT_EQ(count_outside(rasterise({FilledPath{{hill}, kInk}}, kWidth, kHeight, kPaper)), 0);
}

TEST(FindSheet, LightLinesOnADarkGroundAreNoSheet) {
  Colour const chalk = {250, 250, 245};
  auto const picture =
      rasterise({line(ring({300, 220}, 150), 5, chalk), line(box(30, 30, 570, 420), 5, chalk)},
                kWidth, kHeight, {20, 25, 22});
  EXPECT_EQ(count_outside(picture), 0);
}

TEST(FindSheet, AGreyAreaWithALineAroundItIsDrawn) {
  auto outline = box(80, 60, 520, 390);
  DrawList list = {FilledPath{{outline}, {190, 190, 190}}};
  outline.push_back(outline.front());
  list.push_back(line(outline));
  EXPECT_EQ(count_outside(rasterise(list, kWidth, kHeight, {255, 255, 255})), 0);
}

TEST(FindSheet, ASoftShadowAcrossThePageIsNoTable) {
  Picture picture(kWidth, kHeight, kPaper);
  for (int y = 0; y < kHeight; ++y) {
    // Half the light is lost within 14 px.
    double const light = 0.75 + 0.25 * std::clamp((320.0 - y) / 7, -1.0, 1.0);
    for (int x = 0; x < kWidth; ++x) {
      auto const dim = [&](std::uint8_t value) { return static_cast<std::uint8_t>(value * light); };
      picture.at(x, y) = {dim(kPaper.r), dim(kPaper.g), dim(kPaper.b), 255};
    }
  }
  EXPECT_EQ(count_outside(picture), 0);
}

}  // namespace
}  // namespace inkflate
