// SPDX-License-Identifier: Apache-2.0
#include "ink/trace_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "geometry/polyline.h"
#include "io/read_picture.h"
#include "render/rasterise.h"
#include "support/files.h"
#include "support/paper.h"

namespace inkflate {
namespace {

constexpr Colour kPaper = {240, 236, 225};
constexpr Colour kInk = {50, 50, 56};
constexpr Colour kBlue = {60, 90, 200};

StrokedPolyline line(Polyline points, double width_px = 4, Colour colour = kInk) {
  return {std::move(points), {width_px}, {}, colour};
}

Polyline arc(Vec2 centre, double radius_px, double from_rad, double to_rad) {
  Polyline points;
  for (int i = 0; i <= 100; ++i) {
    double const angle_rad = from_rad + (to_rad - from_rad) * i / 100;
    points.push_back(centre + radius_px * Vec2{std::cos(angle_rad), std::sin(angle_rad)});
  }
  return points;
}

Polyline circle(Vec2 centre, double radius_px) { return arc(centre, radius_px, 0, 2 * M_PI); }

Sketch traced(Picture const& picture) {
  auto const sketch = trace_scan(picture);
  EXPECT_TRUE(sketch.has_value()) << sketch.error().message;
  return sketch ? *sketch : Sketch{};
}

Polyline points_of(Stroke const& stroke) {
  Polyline points;
  for (auto const& sample : stroke.samples) points.push_back(sample.position);
  return points;
}

double distance_to(Polyline const& polyline, Vec2 p) {
  double best = squared_norm(p - polyline.front());
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    best = std::min(best, squared_distance_to_segment(p, polyline[i - 1], polyline[i]));
  }
  return std::sqrt(best);
}

/// How far the strokes' samples are from the nearest of the true lines, and the true lines' points from the strokes.
struct Deviation {
  double of_samples_px = 0;
  double of_truth_px = 0;
};
Deviation deviation(Sketch const& sketch, std::vector<Polyline> const& truth) {
  Deviation result;
  std::vector<Polyline> strokes;
  for (auto const& stroke : sketch.strokes) strokes.push_back(points_of(stroke));
  auto const farthest = [](std::vector<Polyline> const& from, std::vector<Polyline> const& to) {
    double most = 0;
    for (auto const& polyline : from) {
      for (auto const p : polyline) {
        double nearest = 1e300;
        for (auto const& other : to) nearest = std::min(nearest, distance_to(other, p));
        most = std::max(most, nearest);
      }
    }
    return most;
  };
  result.of_samples_px = farthest(strokes, truth);
  result.of_truth_px = farthest(truth, strokes);
  return result;
}

/// The largest angle between a chord of the stroke and a direction, as its sine.
double largest_slant(Polyline const& points, Vec2 direction) {
  double most = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    most = std::max(most, std::abs(cross(normalized(points[i] - points[i - 1]), direction)));
  }
  return most;
}

TEST(TraceScan, StrokesLieOnTheLinesOfAPhotographedDrawing) {
  std::vector<Polyline> const truth = {
      circle({150, 160}, 80), {{40, 330}, {390, 290}}, arc({330, 130}, 70, 2.5, 6.0)};
  DrawList list;
  for (auto const& points : truth) list.push_back(line(points));
  auto const photo = test::photographed(rasterise(list, 430, 380, kPaper), 8, 1);
  auto const sketch = traced(photo);
  EXPECT_EQ(sketch.width_px, 430);
  EXPECT_EQ(sketch.height_px, 380);
  ASSERT_EQ(sketch.strokes.size(), 3U);
  auto const off = deviation(sketch, truth);
  EXPECT_LT(off.of_samples_px, 1);
  EXPECT_LT(off.of_truth_px, 2.5);  // the ends are as round as the pen
  for (auto const& stroke : sketch.strokes) {
    EXPECT_NEAR(stroke.width_px, 4, 1);
    EXPECT_EQ(stroke.kind, StrokeKind::Ink);
    EXPECT_NEAR(stroke.colour.r, 255.0 * kInk.r / kPaper.r, 25);
  }
}

TEST(TraceScan, LinesAreNotStairs) {
  for (double const slope : {0.07, 0.1, 0.3, 0.5, 0.9}) {
    SCOPED_TRACE(slope);
    Polyline const truth = {{20, 30}, {280, 30 + 260 * slope}};
    auto const sketch = traced(rasterise({line(truth, 3)}, 300, 320, kPaper));
    ASSERT_EQ(sketch.strokes.size(), 1U);
    Vec2 const direction = normalized(truth[1] - truth[0]);
    Polyline const longer = {truth[0] - 2 * direction, truth[1] + 2 * direction};
    EXPECT_LT(deviation(sketch, {longer}).of_samples_px, 0.15);
    // A stair runs along an axis: off by the line's whole slope.
    EXPECT_LT(largest_slant(points_of(sketch.strokes[0]), direction), 0.05);
  }
}

TEST(TraceScan, ACircleIsOneClosedStroke) {
  auto const sketch = traced(rasterise({line(circle({100, 100}, 60))}, 200, 200, kPaper));
  ASSERT_EQ(sketch.strokes.size(), 1U);
  auto const points = points_of(sketch.strokes[0]);
  EXPECT_EQ(points.front(), points.back());
  EXPECT_NEAR(length(points), 2 * M_PI * 60, 4);
}

TEST(TraceScan, CrossingLinesGoStraightOn) {
  Polyline const rising = {{30, 170}, {270, 40}};
  Polyline const falling = {{40, 30}, {260, 180}};
  auto const sketch = traced(rasterise({line(rising, 5), line(falling, 5)}, 300, 210, kPaper));
  ASSERT_EQ(sketch.strokes.size(), 2U);
  for (auto const& stroke : sketch.strokes) {
    auto const points = points_of(stroke);
    double const to_rising = deviation({0, 0, {}, {stroke}}, {rising}).of_samples_px;
    double const to_falling = deviation({0, 0, {}, {stroke}}, {falling}).of_samples_px;
    EXPECT_LT(std::min(to_rising, to_falling), 1);
    EXPECT_GT(length(points), 230);
  }
}

TEST(TraceScan, BlueLinesAreHelpLines) {
  Polyline const ink = {{30, 40}, {270, 60}};
  Polyline const help = {{150, 20}, {140, 180}};
  auto const picture =
      rasterise({line(ink), line(help, 4, kBlue), line({{20, 180}, {120, 120}})}, 300, 200, kPaper);
  auto const sketch = traced(test::photographed(picture, 5, 2));
  double help_px = 0;
  for (auto const& stroke : sketch.strokes) {
    if (stroke.kind != StrokeKind::HelpLine) continue;
    help_px += length(points_of(stroke));
    EXPECT_LT(deviation({0, 0, {}, {stroke}}, {help}).of_samples_px, 1.2);
  }
  EXPECT_NEAR(help_px, length(help), 12);
  ScanOptions const options = {.help_line_ink = HelpLineInk::None};
  auto const plain = trace_scan(picture, options);
  ASSERT_TRUE(plain.has_value());
  for (auto const& stroke : plain->strokes) EXPECT_EQ(stroke.kind, StrokeKind::Ink);
}

TEST(TraceScan, ADrawingInBlueIsADrawing) {
  auto const sketch = traced(rasterise({line(circle({100, 100}, 60), 4, kBlue)}, 200, 200, kPaper));
  ASSERT_EQ(sketch.strokes.size(), 1U);
  EXPECT_EQ(sketch.strokes[0].kind, StrokeKind::Ink);
}

TEST(TraceScan, SolidAreasBecomeTheLineAroundThem) {
  auto const disc = circle({150, 120}, 60);
  auto const picture =
      rasterise({FilledPath{{disc}, kInk}, line({{20, 220}, {280, 230}})}, 300, 260, kPaper);
  auto const sketch = traced(picture);
  ASSERT_EQ(sketch.strokes.size(), 2U);
  auto const& round = sketch.strokes[0].samples.size() > sketch.strokes[1].samples.size()
                          ? sketch.strokes[0]
                          : sketch.strokes[1];
  auto const points = points_of(round);
  EXPECT_EQ(points.front(), points.back());
  for (auto const p : points) EXPECT_NEAR(distance(p, {150, 120}), 58, 2);
}

TEST(TraceScan, LightLinesOnADarkGroundAreReadAsInk) {
  Polyline const truth = {{30, 150}, {250, 60}};
  auto const sketch = traced(rasterise({line(truth, 4, {250, 250, 245})}, 300, 200, {20, 25, 22}));
  ASSERT_EQ(sketch.strokes.size(), 1U);
  EXPECT_LT(deviation(sketch, {truth}).of_samples_px, 1);
  EXPECT_LT(sketch.strokes[0].colour.r, 60);
}

TEST(TraceScan, ClearPixelsArePaper) {
  Polyline const truth = {{30, 150}, {250, 60}};
  auto const sketch = traced(rasterise({line(truth)}, 300, 200, {0, 0, 0, 0}));
  ASSERT_EQ(sketch.strokes.size(), 1U);
  EXPECT_LT(deviation(sketch, {truth}).of_samples_px, 1);
}

TEST(TraceScan, LargePicturesComeBackInTheirOwnPixels) {
  auto const truth = circle({400, 300}, 220);
  auto const picture = rasterise({line(truth, 12)}, 800, 600, kPaper);
  ScanOptions const options = {.work_side_px = 300};
  auto const sketch = trace_scan(picture, options);
  ASSERT_TRUE(sketch.has_value());
  EXPECT_EQ(sketch->width_px, 800);
  EXPECT_LT(deviation(*sketch, {truth}).of_samples_px, 1);
  ASSERT_EQ(sketch->strokes.size(), 1U);
  EXPECT_NEAR(sketch->strokes[0].width_px, 12, 3);
}

TEST(TraceScan, AnEmptyPageIsRefused) {
  auto const blank = test::photographed(Picture(300, 200, kPaper), 10, 3);
  for (auto const& picture : {blank, Picture(1, 1, kPaper), Picture()}) {
    auto const sketch = trace_scan(picture);
    ASSERT_FALSE(sketch.has_value());
    EXPECT_EQ(sketch.error().code, ErrorCode::NothingThere);
  }
}

TEST(TraceScan, APictureWithoutAnyPaperComesToAnEnd) {
  auto const picture = read_picture(test::data_file("pictures/no_paper.png"));
  ASSERT_TRUE(picture.has_value());
  auto const sketch = trace_scan(*picture);
  EXPECT_TRUE(sketch.has_value() || sketch.error().code == ErrorCode::NothingThere);
}

TEST(TraceScan, BitsAreTheSameOnEveryMachine) {
  auto const picture = rasterise(
      {line({{30, 150}, {150, 60}, {270, 170}}, 5), line({{20, 90}, {280, 110}}, 3, kBlue)}, 300,
      200, kPaper);
  Hash hash;
  for (auto const& stroke : traced(test::photographed(picture, 6, 4)).strokes) {
    hash.add(stroke.width_px);
    for (auto const& sample : stroke.samples) {
      hash.add(sample.position.x);
      hash.add(sample.position.y);
    }
  }
  EXPECT_EQ(hash.value(), 6706081257494209361U);
}

TEST(TraceScan, DustIsNoInk) {
  Polyline const truth = {{30, 150}, {250, 60}};
  DrawList list = {line(truth)};
  list.push_back(Dots{{{50, 40}, {200, 150}, {120, 30}}, 1.5, kInk});
  EXPECT_EQ(traced(rasterise(list, 300, 200, kPaper)).strokes.size(), 1U);
}

TEST(TraceScan, OptionsOutOfRangeAreRefused) {
  Picture const picture(10, 10, kPaper);
  EXPECT_EQ(trace_scan(picture, {.work_side_px = 10}).error().code, ErrorCode::BadOption);
  EXPECT_EQ(trace_scan(picture, {.ink_threshold = 0}).error().code, ErrorCode::BadOption);
}

TEST(TraceScan, CanBeCancelledAtEveryStage) {
  auto const picture = rasterise({line({{10, 10}, {90, 80}})}, 100, 100, kPaper);
  for (int allowed = 0; allowed < 3; ++allowed) {
    int asked = 0;
    Progress progress;
    progress.is_cancelled = [&] { return asked++ >= allowed; };
    EXPECT_EQ(trace_scan(picture, {}, progress).error().code, ErrorCode::Cancelled);
  }
}

}  // namespace
}  // namespace inkflate
