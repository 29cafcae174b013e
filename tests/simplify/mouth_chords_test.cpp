// SPDX-License-Identifier: Apache-2.0
#include "simplify/mouth_chords.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/cubic.h"
#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr double kAnyLength = std::numeric_limits<double>::infinity();

Layer polygon_layer(Contour const& corners) {
  Layer layer;
  layer.outlines.emplace_back();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    layer.outlines[0].pieces.push_back(
        {line_cubic(corners[i], corners[(i + 1) % corners.size()]), RunKind::Ink});
  }
  return layer;
}

Layer box_layer(double left, double top, double right, double bottom) {
  return polygon_layer({{left, top}, {right, top}, {right, bottom}, {left, bottom}});
}

/// A limb between x = 400 and 1000 whose two sides end at x = 400; its chords into hosts. Canvas px are work px.
struct Limb60 {
  std::vector<Layer> hosts = {box_layer(200, 300, 450, 700)};
  Layer own;  // without outlines: the limb encloses nothing
  std::vector<Stroke> strokes = {line_stroke({{400, 470}, {1000, 500}, {400, 530}})};
  double longest_px = kAnyLength;

  std::vector<MouthChord> chords() const {
    auto all = strokes;
    all.push_back(line_stroke({{0, 0}, {0, 1000}}));
    auto const sketch = sketch_of(all);
    auto const space = space_of(sketch);
    auto const samples = samples_of(sketch, 2.5);
    std::vector<LayerArea> areas;
    for (auto const& host : hosts) areas.emplace_back(host, space);
    std::vector<LayerArea const*> pointers;
    for (auto const& area : areas) pointers.push_back(&area);
    auto const ends = loose_ends(sketch, samples);
    if (own.outlines.empty()) return mouth_chords(samples, ends, pointers, nullptr, longest_px);
    LayerArea const own_area(own, space);
    return mouth_chords(samples, ends, pointers, &own_area, longest_px);
  }
};

TEST(MouthChords, JoinTheTwoEndsThatLieInAHost) {
  auto const chords = Limb60().chords();
  ASSERT_EQ(chords.size(), 1U);
  EXPECT_NEAR(distance(chords[0].chord.from, chords[0].chord.to), 60, 1e-6);
}

TEST(MouthChords, NeedAHost) {
  Limb60 limb;
  limb.hosts.clear();
  EXPECT_TRUE(limb.chords().empty());
}

TEST(MouthChords, MayEndJustShortOfTheHost) {
  Limb60 limb;
  limb.hosts = {box_layer(200, 300, 391, 700)};
  EXPECT_EQ(limb.chords().size(), 1U);
  limb.hosts = {box_layer(200, 300, 380, 700)};
  EXPECT_TRUE(limb.chords().empty());
}

TEST(MouthChords, LieOverTheHostMostOfTheWay) {
  Limb60 limb;
  limb.strokes = {line_stroke({{400, 350}, {1000, 500}, {400, 650}})};
  EXPECT_EQ(limb.chords().size(), 1U);
  // A host with a bay, 200 px wide, where the chord runs.
  limb.hosts = {polygon_layer({{200, 300},
                               {450, 300},
                               {450, 400},
                               {300, 400},
                               {300, 600},
                               {450, 600},
                               {450, 700},
                               {200, 700}})};
  EXPECT_TRUE(limb.chords().empty());
}

TEST(MouthChords, DoNotJoinTwoHosts) {
  Limb60 limb;
  limb.hosts = {box_layer(200, 300, 450, 485), box_layer(200, 515, 450, 700)};
  EXPECT_TRUE(limb.chords().empty());
}

TEST(MouthChords, OfTwoHostsAtOnePlaceComeOnce) {
  Limb60 limb;
  limb.hosts.push_back(box_layer(300, 400, 500, 600));
  EXPECT_EQ(limb.chords().size(), 1U);
}

TEST(MouthChords, AreNoLongerThanAskedFor) {
  Limb60 limb;
  limb.longest_px = 59;
  EXPECT_TRUE(limb.chords().empty());
}

TEST(MouthChords, LieBeyondTheLimbThatIsThere) {
  Limb60 limb;
  limb.own = polygon_layer({{600, 480}, {1000, 500}, {600, 520}});
  EXPECT_EQ(limb.chords().size(), 1U);
  limb.own = polygon_layer({{405, 470}, {1000, 500}, {405, 530}});
  EXPECT_TRUE(limb.chords().empty());
}

TEST(MouthChords, AreBoundedInNumber) {
  Limb60 limb;
  limb.strokes.clear();
  for (int i = 0; i < 30; ++i)
    limb.strokes.push_back(line_stroke({{400, 310.0 + 13 * i}, {700 + 10.0 * i, 310.0 + 13 * i}}));
  auto const count = limb.chords().size();
  EXPECT_GT(count, 0U);
  EXPECT_LE(count, 12U);
}

}  // namespace
}  // namespace inkflate
