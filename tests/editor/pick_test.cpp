// SPDX-License-Identifier: Apache-2.0
#include "editor/pick.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr LayerId kFirst{1};
constexpr LayerId kSecond{2};

/// A large disc and a small one before its middle.
Document two_discs() {
  return with_disc(with_disc(empty_document(), {500, 500}, 200), {500, 500}, 50);
}

void hide(Layer& layer) { layer.is_hidden = true; }
void lock(Layer& layer) { layer.is_locked = true; }

TEST(Pick, NearestIsTheFrontLayerAndFarthestTheBackOne) {
  auto const document = two_discs();
  EXPECT_EQ(pick_layer(document, {500, 500}, 0, PickDepth::Nearest), kSecond);
  EXPECT_EQ(pick_layer(document, {500, 500}, 0, PickDepth::Farthest), kFirst);
  EXPECT_EQ(pick_layer(document, {600, 500}, 0, PickDepth::Nearest), kFirst);
}

TEST(Pick, NothingLiesBesideTheLayers) {
  EXPECT_EQ(pick_layer(two_discs(), {900, 500}, 5, PickDepth::Nearest), LayerId::None);
  EXPECT_EQ(pick_layer(empty_document(), {500, 500}, 5, PickDepth::Nearest), LayerId::None);
}

TEST(Pick, ReachGoesBeyondTheRim) {
  auto const document = with_disc(empty_document(), {500, 500}, 100);
  EXPECT_EQ(pick_layer(document, {604, 500}, 5, PickDepth::Nearest), kFirst);
  EXPECT_EQ(pick_layer(document, {606, 500}, 5, PickDepth::Nearest), LayerId::None);
}

TEST(Pick, AHoleIsNotTheLayer) {
  auto const document = with_ring(empty_document(), {500, 500}, 100, 60);
  EXPECT_EQ(pick_layer(document, {500, 500}, 5, PickDepth::Nearest), LayerId::None);
  EXPECT_EQ(pick_layer(document, {580, 500}, 5, PickDepth::Nearest), kFirst);
  EXPECT_EQ(pick_layer(document, {557, 500}, 5, PickDepth::Nearest), kFirst);  // on its rim
}

TEST(Pick, WhereALayerLiesOverItselfItIsTheLayer) {
  auto const doubled = [](Layer& layer) { layer.outlines.push_back(layer.outlines.front()); };
  auto const document = with_changed(with_disc(empty_document(), {500, 500}, 100), kFirst, doubled);
  EXPECT_EQ(pick_layer(document, {500, 500}, 0, PickDepth::Nearest), kFirst);
}

TEST(Pick, HiddenAndLockedLayersAreLookedThrough) {
  for (auto* change : {hide, lock}) {
    auto const document = with_changed(two_discs(), kSecond, change);
    EXPECT_EQ(pick_layer(document, {500, 500}, 0, PickDepth::Nearest), kFirst);
    EXPECT_EQ(layers_in(document, {{0, 0}, {1000, 1000}}), std::vector{kFirst});
    EXPECT_EQ(pickable(document, {kFirst, kSecond, LayerId{77}}), std::vector{kFirst});
  }
}

TEST(Pick, AnOpenLayerLiesUnderItsStrokes) {
  auto const document = with_open(empty_document(), {line_stroke({{100, 100}, {200, 100}})});
  EXPECT_EQ(pick_layer(document, {150, 103}, 5, PickDepth::Nearest), kFirst);
  EXPECT_EQ(pick_layer(document, {150, 110}, 5, PickDepth::Nearest), LayerId::None);
}

TEST(Pick, ABoxTakesLayersThatItTouches) {
  auto const document = with_disc(with_disc(empty_document(), {200, 200}, 50), {600, 600}, 50);
  EXPECT_EQ(layers_in(document, {{0, 0}, {160, 160}}), std::vector{kFirst});
  EXPECT_EQ(layers_in(document, {{0, 0}, {1000, 1000}}), (std::vector{kFirst, kSecond}));
  EXPECT_TRUE(layers_in(document, {{300, 300}, {400, 400}}).empty());
  EXPECT_TRUE(layers_in(document, Rect{}).empty());
}

TEST(Pick, BoxesAreThoseOfOutlinesElseOfStrokes) {
  auto const disc = with_disc(empty_document(), {500, 400}, 100);
  auto const box = layer_box(*disc.layers->front());
  EXPECT_NEAR(box.min.x, 400, 1e-9);
  EXPECT_NEAR(box.max.y, 500, 1e-9);
  auto const open = with_open(empty_document(), {line_stroke({{100, 50}, {200, 100}})});
  EXPECT_EQ(layer_box(*open.layers->front()), (Rect{{100, 50}, {200, 100}}));
  EXPECT_TRUE(box_of(disc, {LayerId{9}}).is_empty());
  EXPECT_TRUE(box_of(empty_document()).is_empty());
}

TEST(Pick, TheBoxOfAllHoldsWhatIsVisible) {
  auto document = with_loose(two_discs(), line_stroke({{10, 20}, {30, 20}}));
  document = with_open(document, {line_stroke({{700, 900}, {800, 950}})});
  EXPECT_EQ(box_of(document).min, (Vec2{10, 20}));
  EXPECT_EQ(box_of(document).max, (Vec2{800, 950}));
  auto const hidden = with_changed(document, LayerId{3}, hide);
  EXPECT_NEAR(box_of(hidden).max.y, 700, 1e-9);
}

TEST(Pick, TheBoxOfAllHoldsDetailsThatStickOut) {
  auto const disc = with_disc(empty_document(), {500, 500}, 100);
  auto const whisker = with_open(empty_document(), {line_stroke({{500, 500}, {50, 480}})});
  auto const both = with_changed(whisker, kFirst, [&](Layer& layer) {
    layer.is_open = false;
    layer.outlines = disc.layers->front()->layer.outlines;
    for (auto& outline : layer.outlines) outline.sources.clear();
    layer.strokes.clear();
    layer.details = {0};
  });
  EXPECT_EQ(box_of(both).min.x, 50);
  EXPECT_NEAR(layer_box(*both.layers->front()).min.x, 400, 1e-9);
  EXPECT_NEAR(box_of(both).max.x, 600, 1e-9);
}

TEST(StrokesNear, AreTheRoughOnesWithinTheRadius) {
  auto document = with_disc(empty_document(), {500, 500}, 100);  // its stroke is not rough
  document = with_loose(document, line_stroke({{0, 0}, {100, 0}}));
  document = with_loose(document, line_stroke({{0, 500}, {1000, 500}}));
  document = with_open(document,
                       {line_stroke({{0, 800}, {1, 800}}), line_stroke({{600, 400}, {600, 600}})});
  auto const found = strokes_near(document, {590, 495}, {590, 495}, 12);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], (StrokeRef{LayerId::None, 1}));
  EXPECT_EQ(found[1], (StrokeRef{kSecond, 1}));
  EXPECT_TRUE(strokes_near(document, {590, 450}, {590, 450}, 5).empty());
}

TEST(StrokesNear, AStretchCountsBetweenItsEndsToo) {
  auto const document = with_loose(empty_document(), line_stroke({{50, -100}, {50, 100}}));
  EXPECT_EQ(strokes_near(document, {0, 0}, {100, 0}, 1).size(), 1u);
  EXPECT_TRUE(strokes_near(document, {0, 200}, {100, 200}, 1).empty());
}

TEST(StrokesNear, ADotIsMetAndATouchIsNot) {
  auto const document = with_loose(empty_document(), line_stroke({{50, 50}}));
  EXPECT_EQ(strokes_near(document, {50, 59}, {50, 59}, 10).size(), 1u);
  EXPECT_TRUE(strokes_near(document, {50, 60}, {50, 60}, 10).empty());
}

TEST(StrokesNear, StrokesOfLockedOrHiddenLayersAreSafe) {
  auto const document = with_open(empty_document(), {line_stroke({{0, 0}, {100, 0}})});
  for (auto* change : {hide, lock}) {
    EXPECT_TRUE(strokes_near(with_changed(document, kFirst, change), {50, 0}, {50, 0}, 5).empty());
  }
}

TEST(Pick, NumbersThatAreNoneFindNothing) {
  auto const document = with_loose(two_discs(), line_stroke({{0, 0}, {9, 9}}));
  double const nan = std::numeric_limits<double>::quiet_NaN();
  double const huge = 1e300;
  for (Vec2 const p : {Vec2{nan, 500}, Vec2{nan, nan}, Vec2{huge, -huge}}) {
    EXPECT_EQ(pick_layer(document, p, 5, PickDepth::Nearest), LayerId::None);
    EXPECT_TRUE(strokes_near(document, p, p, 5).empty());
  }
  EXPECT_EQ(pick_layer(document, {0, 0}, nan, PickDepth::Nearest), LayerId::None);
}

}  // namespace
}  // namespace inkflate
