// SPDX-License-Identifier: Apache-2.0
#include "simplify/limb_mouths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/sketches.h"

namespace inkflate {
namespace {

/// A body that reaches from x = 100 to 500, and what else there is.
struct Scene {
  Sketch sketch = sketch_of({arc_stroke({300, 500}, 200, 300, 0, 2 * M_PI)});

  Scene() {
    sketch.groups = {{"body"}};
    sketch.strokes[0].group = 0;
  }

  void add(std::string const& group, std::vector<Stroke> strokes) {
    if (sketch.groups.back().name != group) sketch.groups.push_back({group});
    for (auto& stroke : strokes) {
      stroke.group = static_cast<int>(std::ssize(sketch.groups)) - 1;
      sketch.strokes.push_back(std::move(stroke));
    }
  }

  Drawing simplified(SimplifyOptions options = {}) const {
    options.parts = Parts::Groups;
    auto const drawing = simplify(sketch, options);
    EXPECT_TRUE(drawing.has_value()) << drawing.error().message;
    if (!drawing) return {};
    EXPECT_EQ(what_is_wrong(*drawing), "");
    EXPECT_TRUE(drawing->sketch == sketch);
    return *drawing;
  }
};

/// A tube 60 px wide about a line at height y, from its open end to a pointed tip, with a cross line at each of the places.
std::vector<Stroke> tube(double y, double open_x, double tip_x, std::vector<double> const& bands) {
  double const neck_x = tip_x - (tip_x > open_x ? 40 : -40);
  std::vector<Stroke> strokes = {line_stroke({{open_x, y - 30}, {neck_x, y - 30}, {tip_x, y}}),
                                 line_stroke({{open_x, y + 30}, {neck_x, y + 30}, {tip_x, y}})};
  for (double const x : bands) strokes.push_back(line_stroke({{x, y - 30}, {x, y + 30}}));
  return strokes;
}

double area(Layer const& layer) { return signed_area(flatten(layer.outlines[0], 0.1)); }

Rect box(Layer const& layer) { return bounds(flatten(layer.outlines[0], 0.1)); }

/// Length of the closings, and of those of them that run along a vertical line.
double closing_length(Layer const& layer, double x) {
  double sum = 0;
  for (auto const& run : runs(layer.outlines[0], 0.1)) {
    if (run.kind != RunKind::Closing) continue;
    for (std::size_t i = 1; i < run.points.size(); ++i) {
      bool const is_there =
          std::abs(run.points[i - 1].x - x) < 4 && std::abs(run.points[i].x - x) < 4;
      if (is_there) sum += distance(run.points[i - 1], run.points[i]);
    }
  }
  return sum;
}

TEST(LimbMouths, ABandedLimbReachesIntoTheBody) {
  Scene scene;
  scene.add("arm", tube(500, 440, 800, {560, 620, 680}));
  auto const drawing = scene.simplified();
  ASSERT_EQ(drawing.layers.size(), 2U);
  EXPECT_EQ(drawing.layers[1].name, "arm");
  EXPECT_NEAR(box(drawing.layers[1]).min.x, 440, 4);
  EXPECT_NEAR(area(drawing.layers[1]), 60 * 320 + 60 * 40 / 2.0, 600);
}

TEST(LimbMouths, TheMouthIsAClosingAndNothingElse) {
  Scene scene;
  scene.add("arm", tube(500, 440, 800, {560, 620, 680}));
  auto const layer = scene.simplified().layers[1];
  EXPECT_NEAR(closing_length(layer, 440), 60, 3);
  for (auto const& piece : layer.outlines[0].pieces) EXPECT_NE(piece.kind, RunKind::HelpLine);
  for (auto const& source : layer.outlines[0].sources) EXPECT_LE(source.stroke, 5);
}

TEST(LimbMouths, TheBandsBecomeDetails) {
  Scene scene;
  scene.add("arm", tube(500, 440, 800, {560, 620, 680}));
  auto const layer = scene.simplified().layers[1];
  EXPECT_EQ(layer.strokes, (std::vector<int>{1, 2}));
  EXPECT_EQ(layer.details, (std::vector<int>{3, 4, 5}));
}

TEST(LimbMouths, ALimbFarFromAnyBodyStaysAsItWas) {
  Scene scene;
  scene.add("arm", tube(500, 540, 900, {660, 720, 780}));
  auto const layer = scene.simplified().layers[1];
  EXPECT_GT(box(layer).min.x, 650);  // ends at its first band
}

TEST(LimbMouths, ALimbThatEndsJustShortOfTheBodyIsClosed) {
  Scene scene;
  scene.add("arm", tube(500, 506, 866, {626, 686, 746}));
  EXPECT_NEAR(box(scene.simplified().layers[1]).min.x, 506, 4);
}

TEST(LimbMouths, AnOpenArcAtTheBodyIsAFoot) {
  Scene scene;
  scene.add("foot", {arc_stroke({300, 765}, 90, 50, 0, M_PI)});
  auto const drawing = scene.simplified();
  ASSERT_EQ(drawing.layers.size(), 2U);
  EXPECT_EQ(drawing.layers[1].name, "foot");
  EXPECT_NEAR(area(drawing.layers[1]), M_PI * 90 * 50 / 2, 0.06 * M_PI * 90 * 50 / 2);
}

TEST(LimbMouths, ASmileIsNoFoot) {
  Scene scene;
  scene.add("face", {arc_stroke({300, 500}, 90, 45, 0, M_PI)});
  auto const drawing = scene.simplified();
  EXPECT_EQ(drawing.layers.size(), 1U);
  EXPECT_EQ(drawing.stray, std::vector<int>{1});
}

TEST(LimbMouths, EveryLimbOfAGroupIsClosedByItself) {
  Scene scene;
  scene.add("arms", tube(330, 420, 800, {560, 620, 680}));
  scene.add("arms", tube(500, 440, 850, {570, 630, 690}));
  scene.add("arms", tube(670, 420, 700, {560, 620}));
  auto const drawing = scene.simplified();
  ASSERT_EQ(drawing.layers.size(), 4U);
  for (int k = 1; k < 4; ++k) {
    EXPECT_NEAR(box(drawing.layers[k]).min.x, k == 1 ? 440 : 420, 4) << k;
    EXPECT_NEAR(box(drawing.layers[k]).height(), 60, 6) << k;
  }
  EXPECT_EQ(drawing.layers[1].name, "arms");
  EXPECT_EQ(drawing.layers[2].name, "arms 2");
}

TEST(LimbMouths, LimbsThatTouchInTheBodyStayApart) {
  Scene scene;
  scene.add("arms", tube(500, 440, 800, {560, 620, 680}));
  auto second =
      tube(440, 440, 800, {560, 620, 680});  // its lower side ends where the first's upper one does
  for (auto& stroke : second) {
    for (auto& sample : stroke.samples) {
      auto const off = sample.position - Vec2{440, 470};
      sample.position = Vec2{440, 470} + off * std::cos(0.6) - perpendicular(off) * std::sin(0.6);
    }
  }
  scene.add("arms", second);
  auto const drawing = scene.simplified();
  ASSERT_EQ(drawing.layers.size(), 3U);
  for (int k = 1; k < 3; ++k)
    EXPECT_NEAR(area(drawing.layers[k]), 60 * 320 + 60 * 40 / 2.0, 600) << k;
}

TEST(LimbMouths, LimbsOnBothSidesMayBeOneTube) {
  Scene scene;
  std::vector<Stroke> rod = {
      line_stroke({{180, 470}, {900, 470}}), line_stroke({{180, 530}, {900, 530}}),
      line_stroke({{560, 470}, {560, 530}}), line_stroke({{700, 470}, {700, 530}})};
  scene.add("rod", rod);
  scene.add("far", {circle_stroke({900, 500}, 80)});
  auto const drawing = scene.simplified();
  ASSERT_EQ(drawing.layers.size(), 3U);
  EXPECT_NEAR(area(drawing.layers[1]), 720 * 60, 1500);
  EXPECT_NEAR(closing_length(drawing.layers[1], 180), 60, 3);
  EXPECT_NEAR(closing_length(drawing.layers[1], 900), 60, 3);
}

TEST(LimbMouths, SidesDrawnTwiceEndWhereTheLongerOneEnds) {
  Scene scene;
  auto strokes = tube(500, 440, 800, {560, 620, 680});
  strokes.push_back(line_stroke({{470, 473}, {700, 473}}));
  strokes.push_back(line_stroke({{480, 527}, {720, 527}}));
  scene.add("arm", strokes);
  EXPECT_NEAR(box(scene.simplified().layers[1]).min.x, 440, 4);
}

TEST(LimbMouths, ABayBetweenTwoTipsStaysOpen) {
  Scene scene;
  // A comb whose two teeth point into the body from the right; its outline is closed, and overshoots at the tips.
  scene.add("comb",
            {line_stroke({{432, 398}, {470, 410}, {700, 410}, {700, 590}, {470, 590}, {432, 602}}),
             line_stroke({{430, 410}, {530, 440}, {560, 500}, {530, 560}, {430, 590}})});
  auto const layer = scene.simplified().layers[1];
  EXPECT_FALSE(contains(flatten(layer.outlines[0], 0.1), {500, 500}));
}

TEST(LimbMouths, AHelpLineClosesInsteadOfAChord) {
  Scene scene;
  auto strokes = tube(500, 440, 800, {560, 620, 680});
  strokes.push_back(arc_stroke({440, 500}, 20, 30, 1.5 * M_PI, 0.5 * M_PI, StrokeKind::HelpLine));
  scene.add("arm", strokes);
  auto const layer = scene.simplified().layers[1];
  EXPECT_EQ(closing_length(layer, 440), 0);
  EXPECT_NEAR(box(layer).min.x, 420, 4);
}

TEST(LimbMouths, NoClosingIsLongerThanTheGapThatIsAskedFor) {
  Scene scene;
  scene.add("arm", tube(500, 440, 800, {560, 620, 680}));
  EXPECT_GT(box(scene.simplified({.gap_px = 40}).layers[1]).min.x, 540);
  EXPECT_NEAR(box(scene.simplified({.gap_px = 80}).layers[1]).min.x, 440, 4);
}

TEST(LimbMouths, ConstructionLinesAreNoBodyAndNoLimb) {
  Scene scene;
  scene.sketch.groups[0].name = "construction";
  scene.add("arm", tube(500, 440, 800, {560, 620, 680}));
  EXPECT_GT(box(scene.simplified().layers[0]).min.x, 540);
  Scene other;
  other.add("construction", tube(500, 440, 800, {560, 620, 680}));
  EXPECT_EQ(other.simplified().layers.size(), 1U);
}

TEST(LimbMouths, OtherPartsAreNotLookedForUnlessGroupsAreLayers) {
  Scene scene;
  scene.add("arm", tube(500, 440, 800, {560, 620, 680}));
  auto ungrouped = scene.sketch;
  for (auto& stroke : ungrouped.strokes) stroke.group = -1;
  for (auto const parts : {Parts::One, Parts::All}) {
    auto const with = simplify(scene.sketch, {.parts = parts});
    auto const without = simplify(ungrouped, {.parts = parts});
    ASSERT_TRUE(with.has_value() && without.has_value());
    ASSERT_EQ(with->layers.size(), without->layers.size());
    for (std::size_t k = 0; k < with->layers.size(); ++k)
      EXPECT_EQ(with->layers[k].outlines, without->layers[k].outlines);
  }
}

TEST(LimbMouths, TheOrderOfGroupsPlaysNoPart) {
  Scene scene;
  scene.add("arm", tube(500, 440, 800, {560, 620, 680}));
  auto const drawing = scene.simplified();
  auto swapped = scene.sketch;
  std::swap(swapped.groups[0], swapped.groups[1]);
  for (auto& stroke : swapped.strokes) stroke.group = 1 - stroke.group;
  auto const other = simplify(swapped, {.parts = Parts::Groups});
  ASSERT_TRUE(other.has_value());
  ASSERT_EQ(other->layers.size(), 2U);
  EXPECT_EQ(other->layers[0].outlines, drawing.layers[1].outlines);
  EXPECT_EQ(other->layers[1].outlines, drawing.layers[0].outlines);
}

TEST(LimbMouths, CanBeCancelled) {
  Scene scene;
  scene.add("arm", tube(500, 440, 800, {560, 620, 680}));
  bool is_closing = false;
  Progress const progress = {
      [&](std::string_view stage) { is_closing = is_closing || stage == "mouths"; },
      [&] { return is_closing; }};
  auto const drawing = simplify(scene.sketch, {.parts = Parts::Groups}, progress);
  EXPECT_TRUE(is_closing);
  ASSERT_FALSE(drawing.has_value());
  EXPECT_EQ(drawing.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace inkflate
