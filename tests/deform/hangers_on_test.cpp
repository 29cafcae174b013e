// SPDX-License-Identifier: Apache-2.0
#include "deform/hangers_on.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/bend_meshes.h"

namespace inkflate {
namespace {

// A bar of 400 x 40 px in squares of 10 px, of which all but a middle stretch stays.
struct Stretch {
  BendMesh bar = support::bar_mesh(400, 40, 40, 4);
  std::vector<double> way_px;
  std::vector<char> stays;

  Stretch(double from_px, double to_px) {
    for (auto const p : bar.rest.points) {
      way_px.push_back(std::max(0.0, std::max(from_px - p.x, p.x - to_px)));
      stays.push_back(way_px.back() > 0);
    }
  }
  bool stays_at(Vec2 place) const { return stays[support::nearest_vertex(bar.rest, place)] != 0; }
};

TEST(HangersOn, AreSmallEnds) {
  Stretch stretch(20, 300);
  free_hangers_on(stretch.bar.rest, stretch.way_px, stretch.stays);
  EXPECT_FALSE(stretch.stays_at({0, 0}));
  EXPECT_TRUE(stretch.stays_at({400, 0}));
}

TEST(HangersOn, AreNoLargeEnds) {
  Stretch stretch(100, 300);
  auto const before = stretch.stays;
  free_hangers_on(stretch.bar.rest, stretch.way_px, stretch.stays);
  EXPECT_EQ(stretch.stays, before);
}

TEST(HangersOn, HangOnWhatMoves) {
  Stretch stretch(20, 300);
  for (auto& way : stretch.way_px) {
    if (way > 0) way = std::numeric_limits<double>::infinity();
  }
  auto const before = stretch.stays;
  free_hangers_on(stretch.bar.rest, stretch.way_px, stretch.stays);
  EXPECT_EQ(stretch.stays, before);
}

}  // namespace
}  // namespace inkflate
