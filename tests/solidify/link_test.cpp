// SPDX-License-Identifier: Apache-2.0
#include "solidify/link.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

LinkSides all(NodeSide side) {
  LinkSides link{};
  link.fill(side);
  return link;
}

TEST(Link, RingsHaveFourNeighboursAlongAxesAndSixAlongDiagonals) {
  for (int d = 0; d < kDirections; ++d) {
    auto const ring = ring_around(d);
    EXPECT_EQ(ring.size(), d < kLongDirections ? 4U : 6U);
    for (std::size_t r = 0; r < ring.size(); ++r) {
      auto const gap = kSteps[ring[r]] - kSteps[ring[(r + 1) % ring.size()]];
      int const squared = gap.i * gap.i + gap.j * gap.j + gap.k * gap.k;
      EXPECT_TRUE(squared == 3 || squared == 4) << "members that are no neighbours";
    }
  }
}

TEST(Link, PlaneThroughANodeIsADisc) {
  LinkSides link{};
  for (int d = 0; d < kDirections; ++d)
    link[d] = kSteps[d].k + 0.1 * kSteps[d].i + 0.01 * kSteps[d].j > 0 ? NodeSide::Inside
                                                                       : NodeSide::Outside;
  EXPECT_TRUE(is_disc(link));
}

TEST(Link, NodeWithoutTwoSidesIsNoDisc) {
  EXPECT_FALSE(is_disc(all(NodeSide::Inside)));
  EXPECT_FALSE(is_disc(all(NodeSide::Outside)));
}

TEST(Link, SheetThroughANodeIsNoDisc) {
  auto link = all(NodeSide::Outside);
  link[0] = NodeSide::Inside;
  EXPECT_TRUE(is_disc(link));
  link[1] = NodeSide::Inside;
  EXPECT_FALSE(is_disc(link)) << "two pieces inside would meet in the node";
}

TEST(Link, TunnelThroughANodeIsNoDisc) {
  auto link = all(NodeSide::Inside);
  link[0] = NodeSide::Outside;
  link[1] = NodeSide::Outside;
  EXPECT_FALSE(is_disc(link));
}

TEST(Link, TetrahedronOnTheSurfaceIsRefused) {
  LinkSides link{};
  for (int d = 0; d < kDirections; ++d)
    link[d] = kSteps[d].k > 0 ? NodeSide::Inside : NodeSide::Outside;
  link[0] = NodeSide::On;
  EXPECT_TRUE(is_disc(link));
  link[ring_around(0)[0]] = NodeSide::On;
  link[ring_around(0)[1]] = NodeSide::On;
  EXPECT_FALSE(is_disc(link));
}

}  // namespace
}  // namespace inkflate
