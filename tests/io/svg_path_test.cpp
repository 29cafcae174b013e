// SPDX-License-Identifier: Apache-2.0
#include "io/svg_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/trig.h"

namespace inkflate {
namespace {

std::vector<Polyline> trace(std::string_view data, bool expect_whole = true) {
  PathTracer tracer({}, 1'000'000);
  EXPECT_EQ(trace_path(data, tracer), expect_whole) << data;
  EXPECT_EQ(tracer.fault(), TraceFault::None);
  return tracer.take_subpaths();
}

Polyline const kSquare = {{1, 2}, {4, 2}, {4, 6}, {1, 6}, {1, 2}};

TEST(SvgPath, EveryWayToWriteASquareIsTheSame) {
  for (char const* data :
       {"M1 2L4 2L4 6L1 6L1 2", "M1,2 4,2 4,6 1,6z", "m1 2l3 0l0 4l-3 0z", "m1 2 3 0 0 4-3 0Z",
        "M1 2H4V6H1Z", "m1 2h3v4h-3z", " M 1 , 2 H 4 V 6 H 1 z ", "M1 2h+3v4.0h-.3e1z",
        "m1,2\n3,0\t0,4\r-3-0,z"}) {
    EXPECT_EQ(trace(data), std::vector<Polyline>{kSquare}) << data;
  }
}

TEST(SvgPath, CompactNumbersAreSplit) {
  EXPECT_EQ(trace("M.5.25L1-2.5.5-1e1"),
            (std::vector<Polyline>{{{.5, .25}, {1, -2.5}, {.5, -10}}}));
}

TEST(SvgPath, ClosedSubpathsRepeatTheirStartAndGoOnFromIt) {
  EXPECT_EQ(trace("M0 0L2 0L2 2zl1 1M5 5l1 0zz"),
            (std::vector<Polyline>{
                {{0, 0}, {2, 0}, {2, 2}, {0, 0}}, {{0, 0}, {1, 1}}, {{5, 5}, {6, 5}, {5, 5}}}));
}

TEST(SvgPath, MovesAloneDrawNothing) {
  EXPECT_EQ(trace("M1 2M3 4").size(), 0U);
  EXPECT_EQ(trace("").size(), 0U);
}

TEST(SvgPath, CubicsStayOnTheCurve) {
  Cubic const curve = {{Vec2{0, 0}, Vec2{0, 50}, Vec2{80, 50}, Vec2{80, 0}}};
  auto const absolute = trace("M0 0C0 50 80 50 80 0");
  EXPECT_EQ(absolute, trace("m0 0c0 50 80 50 80 0"));
  std::vector<Vec2> expected = {{0, 0}};
  flatten_into(curve, 0.1, expected);
  EXPECT_EQ(absolute[0], expected);
}

TEST(SvgPath, SmoothCommandsMirrorTheControl) {
  EXPECT_EQ(trace("M0 0C0 10 10 10 10 0S20-10 20 0"),
            trace("M0 0C0 10 10 10 10 0C10-10 20-10 20 0"));
  EXPECT_EQ(trace("M0 0c0 10 10 10 10 0s10-10 10 0"), trace("M0 0C0 10 10 10 10 0S20-10 20 0"));
  EXPECT_EQ(trace("M0 0Q5 10 10 0T20 0"), trace("M0 0Q5 10 10 0Q15-10 20 0"));
  EXPECT_EQ(trace("M0 0q5 10 10 0t10 0t10 0"), trace("M0 0Q5 10 10 0Q15-10 20 0Q25 10 30 0"));
}

TEST(SvgPath, SmoothCommandsWithoutACurveBeforeThemMirrorNothing) {
  EXPECT_EQ(trace("M1 1S5 9 9 1"), trace("M1 1C1 1 5 9 9 1"));
  EXPECT_EQ(trace("M1 1T9 1")[0].back(), (Vec2{9, 1}));
  EXPECT_EQ(trace("M0 0C0 9 9 9 9 0T20 0")[0].back(), (Vec2{20, 0}));
}

TEST(SvgPath, ArcsLieOnTheirCircle) {
  // From (10, 0) to (0, 10) on circles of radius 10 there are four arcs.
  struct Case {
    char const* flags;
    Vec2 centre;
    double length;
  };
  double const quarter = 10 * kPi / 2;
  for (auto const& [flags, centre, expected] :
       {Case{"0 0", {10, 10}, quarter}, Case{"0 1", {0, 0}, quarter},
        Case{"1 0", {0, 0}, 3 * quarter}, Case{"1 1", {10, 10}, 3 * quarter}}) {
    auto const arc = trace("M10 0A10 10 0 " + std::string(flags) + " 0 10");
    ASSERT_EQ(arc.size(), 1U);
    for (auto const p : arc[0]) EXPECT_NEAR(distance(p, centre), 10, 1e-4) << flags;
    EXPECT_NEAR(length(arc[0]), expected, 0.01 * expected) << flags;
    EXPECT_EQ(arc[0].back(), (Vec2{0, 10}));
  }
}

TEST(SvgPath, ArcFlagsNeedNoSeparators) {
  EXPECT_EQ(trace("M10 0a10 10 0 01-10 10"), trace("M10 0A10 10 0 0 1 0 10"));
  EXPECT_EQ(trace("M10 0A10 10 0 0010 5"), trace("M10 0A10 10 0 0 0 10 5"));
}

TEST(SvgPath, ArcRadiiTooSmallGrow) {
  auto const arc = trace("M0 0A1 1 0 0 1 20 0");
  for (auto const p : arc[0]) EXPECT_NEAR(distance(p, {10, 0}), 10, 1e-4);
}

TEST(SvgPath, TurnedArcsLieOnTheirEllipse) {
  auto const arc = trace("M0 0A20 10 90 0 1 0 40");
  for (auto const p : arc[0]) {
    EXPECT_NEAR(p.x * p.x / 100 + (p.y - 20) * (p.y - 20) / 400, 1, 1e-4);
    EXPECT_GE(p.x, -1e-9);  // sweeping means turning right on the screen: over the right side
  }
}

TEST(SvgPath, ArcsWithoutRadiusOrLengthDegenerate) {
  EXPECT_EQ(trace("M0 0A0 5 0 0 1 9 9"), (std::vector<Polyline>{{{0, 0}, {9, 9}}}));
  EXPECT_EQ(trace("M3 3A5 5 0 0 1 3 3"), (std::vector<Polyline>{}));
}

TEST(SvgPath, DamageKeepsWhatCameBefore) {
  std::vector<Polyline> const line = {{{0, 0}, {5, 5}}};
  for (char const* data :
       {"M0 0L5 5L", "M0 0L5 5L6", "M0 0L5 5X1", "M0 0L5 5Lnan 1", "M0 0L5 5C1 1 2 2",
        "M0 0L5 5A1 1 0 2 0 9 9", "M0 0L5 5L1e999 0", "M0 0L5 5Z 3 3"}) {
    auto const subpaths = trace(data, false);
    ASSERT_EQ(subpaths.size(), 1U) << data;
    EXPECT_EQ(subpaths[0][1], line[0][1]);
  }
  EXPECT_EQ(trace("L5 5", false).size(), 0U);
  EXPECT_EQ(trace("5 5", false).size(), 0U);
}

TEST(SvgPath, FarCoordinatesAndLongPathsAreFaults) {
  PathTracer far({}, 100);
  trace_path("M0 0L1e300 0", far);
  EXPECT_EQ(far.fault(), TraceFault::OutOfRange);
  PathTracer bent({}, 100);
  trace_path("M0 0C1e308 1e308 -1e308 1e308 5 5", bent);
  EXPECT_EQ(bent.fault(), TraceFault::OutOfRange);
  PathTracer round({}, 100);
  trace_path("M0 0A1e-300 1e-300 0 0 1 5 5A1e300 1e300 7 1 1 0 0", round);
  EXPECT_NE(round.fault(), TraceFault::TooManyPoints);
  PathTracer longer({}, 3);
  trace_path("M0 0L1 0 2 0 3 0 4 0", longer);
  EXPECT_EQ(longer.fault(), TraceFault::TooManyPoints);
}

}  // namespace
}  // namespace inkflate
