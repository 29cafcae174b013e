// SPDX-License-Identifier: Apache-2.0
#include "assemble/untangle_rim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "assemble/assemble.h"
#include "base/rng.h"
#include "geometry/crossings.h"
#include "geometry/trig.h"
#include "support/characters.h"
#include "support/surfaces.h"

namespace inkflate {
namespace {

constexpr double kStepPx = 1.5;

bool is_simple_rim(LayerRim const& rim) {
  std::vector<Contour> contours = {outer_contour(rim)};
  contours.insert(contours.end(), rim.holes.begin(), rim.holes.end());
  return find_crossings(contours, 1).empty();
}

/// A body of 400 x 500 px with an arm of 80 px that leaves its right side and comes back over it. Between them lie 120 x 140 px.
Contour bent_arm() {
  return {{300, 300}, {700, 300}, {700, 340}, {900, 340}, {900, 640}, {450, 640},
          {450, 560}, {820, 560}, {820, 420}, {700, 420}, {700, 800}, {300, 800}};
}

/// A band around a line that wanders, so that it lies over itself anywhere; it may turn over where it is narrower than its bends.
Contour wandering_band(Rng& rng) {
  Polyline left;
  Polyline right;
  Vec2 place = {500, 500};
  double angle_rad = 0;
  double bend_rad = 0;
  for (int i = 0; i < 120; ++i) {
    bend_rad = 0.9 * bend_rad + rng.uniform(-0.12, 0.12);
    angle_rad += bend_rad;
    auto const along = sin_cos(angle_rad);
    place += Vec2{along.cos, along.sin} * 12;
    Vec2 const aside = Vec2{-along.sin, along.cos} * 35;
    left.push_back(place - aside);
    right.push_back(place + aside);
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  return left;
}

MeshCheck sound_surface(Drawing const& drawing) {
  auto const model = assemble(drawing);
  EXPECT_TRUE(model.has_value()) << model.error().message;
  if (!model) return {};
  return sound_surface(*model);
}

TEST(UntangleRim, ASimpleRimStaysAsItIs) {
  for (auto const& layer :
       {limb_layer("arm", {300, 300}, {700, 500}, 40), ring_layer("ring", {500, 500}, 100, 300)}) {
    auto const rim = layer_rim(layer, kStepPx);
    auto const again = untangled(rim, kStepPx);
    ASSERT_EQ(again.runs.size(), rim.runs.size());
    for (std::size_t r = 0; r < rim.runs.size(); ++r) {
      EXPECT_EQ(again.runs[r].points, rim.runs[r].points);
      EXPECT_EQ(again.runs[r].opening, rim.runs[r].opening);
    }
    EXPECT_EQ(again.holes, rim.holes);
  }
}

TEST(UntangleRim, AnArmOverItsBodyEnclosesAHole) {
  auto const rim = layer_rim(drawn_layer("bent", bent_arm()), kStepPx);
  EXPECT_TRUE(is_simple_rim(rim));
  ASSERT_EQ(rim.holes.size(), 1U);
  EXPECT_NEAR(signed_area(rim.holes[0]), -120 * 140, 0.1);
  // Body and arm, less where one lies over the other.
  EXPECT_NEAR(signed_area(outer_contour(rim)), 400 * 500 + 200 * 300, 0.1);
}

TEST(UntangleRim, AHoleThatIsCoveredIsFilled) {
  auto layer = drawn_layer("bent", bent_arm());
  auto const hole = ring_layer("ring", {580, 600}, 20, 100).outlines[1];
  layer.outlines.push_back(hole);
  EXPECT_EQ(layer_rim(layer, kStepPx).holes.size(), 1U);
}

TEST(UntangleRim, AMouthStaysOpenWhileHalfOfItIsLeft) {
  // Only the end of the limb lies over its own side.
  auto limb = drawn_layer("limb", {{100, 100},
                                   {900, 100},
                                   {900, 500},
                                   {400, 500},
                                   {400, 60},
                                   {500, 60},
                                   {500, 400},
                                   {800, 400},
                                   {800, 200},
                                   {100, 200}});
  limb.outlines[0].pieces.back().kind = RunKind::HelpLine;
  auto const openings = [](LayerRim const& rim) {
    return std::count_if(rim.runs.begin(), rim.runs.end(), [](RimRun const& run) {
      return run.opening == Opening::Wanted && run.points.front() != run.points.back();
    });
  };
  EXPECT_EQ(openings(layer_rim(limb, kStepPx)), 1);
  EXPECT_EQ(sound_surface(drawing_of({limb})).shells, 1);
  // The end of this one lies over its own mouth.
  auto shut = drawn_layer("limb", {{100, 100},
                                   {900, 100},
                                   {900, 500},
                                   {50, 500},
                                   {50, 80},
                                   {150, 80},
                                   {150, 400},
                                   {800, 400},
                                   {800, 200},
                                   {100, 200}});
  shut.outlines[0].pieces.back().kind = RunKind::HelpLine;
  EXPECT_EQ(openings(layer_rim(shut, kStepPx)), 0);
  EXPECT_EQ(sound_surface(drawing_of({shut})).shells, 1);
}

TEST(UntangleRim, APartBentOverItselfBecomesAClosedSurface) {
  auto const found = sound_surface(drawing_of({drawn_layer("bent", bent_arm())}));
  EXPECT_EQ(found.shells, 1);
  EXPECT_EQ(found.genus, 1);
}

TEST(UntangleRim, AFigureOfEightIsOnePiece) {
  auto const found = sound_surface(drawing_of({drawn_layer(
      "eight", {{200, 300}, {500, 500}, {800, 300}, {800, 700}, {500, 500}, {200, 700}})}));
  EXPECT_EQ(found.shells, 1);
  EXPECT_EQ(found.genus, 0);
}

TEST(UntangleRim, OfPiecesThatAreApartTheLargestIsKept) {
  auto layer = drawn_layer("large", ellipse_contour({400, 500}, 300, 300));
  layer.outlines.push_back(drawn_layer("small", ellipse_contour({900, 500}, 90, 90)).outlines[0]);
  auto const rim = layer_rim(layer, kStepPx);
  EXPECT_TRUE(rim.holes.empty());
  EXPECT_NEAR(bounds(outer_contour(rim)).max.x, 700, 1);
}

TEST(UntangleRim, BandsThatWanderOverThemselvesBecomeClosedSurfaces) {
  Rng rng(1);
  int tangled = 0;
  for (int i = 0; i < 20; ++i) {
    auto const layer = drawn_layer("band", wandering_band(rng));
    tangled += is_simple(flatten(layer.outlines[0], 0.1)) ? 0 : 1;
    EXPECT_TRUE(is_simple_rim(layer_rim(layer, kStepPx)));
    EXPECT_EQ(sound_surface(drawing_of({layer})).shells, 1);
  }
  EXPECT_GT(tangled, 6);
}

}  // namespace
}  // namespace inkflate
