// SPDX-License-Identifier: Apache-2.0
#include "solidify/line_spans.h"

#include <gtest/gtest.h>

#include "support/solid_shapes.h"

namespace inkflate {
namespace {

constexpr Lattice kLattice{20, 20, 40};

LatticeMesh laid_out(TriMesh const& model) {
  LatticeMesh mesh;
  mesh.triangles = model.triangles;
  for (auto const& p : model.points) {
    auto const quanta = [](double x) { return static_cast<std::int64_t>(x * kQuanta); };
    mesh.points.push_back({quanta(p.x), quanta(p.y), quanta(p.z)});
  }
  return mesh;
}

std::vector<double> crossings_at(TriMesh const& model, int family, LatticeNode node) {
  LineSpans spans(kLattice, family);
  EXPECT_TRUE(spans.scan(laid_out(model)).has_value());
  std::vector<double> at;
  for (auto const& crossing : spans.crossings(spans.line(node))) at.push_back(crossing.at);
  return at;
}

TEST(LineSpans, PlaceOfANodesPositionIsTheNode) {
  for (int f = 0; f < kFamilies; ++f) {
    LineSpans const spans(kLattice, f);
    for (LatticeNode const node : {LatticeNode{4, 6, 8}, {7, 3, 11}, {2, 38, 36}}) {
      EXPECT_LT(spans.line(node), spans.line_count());
      EXPECT_EQ(spans.place(spans.line(node), spans.position(node)), place_of(node));
    }
  }
}

TEST(LineSpans, EveryDirectionFindsBothSidesOfABox) {
  auto const box = shapes::box({10.5, 9.5, 8.5}, {20.5, 19.5, 18.5});
  EXPECT_EQ(crossings_at(box, 0, {14, 14, 14}), (std::vector{10.5, 20.5}));
  EXPECT_EQ(crossings_at(box, 1, {14, 14, 14}), (std::vector{9.5, 19.5}));
  EXPECT_EQ(crossings_at(box, 2, {14, 14, 14}), (std::vector{8.5, 18.5}));
  EXPECT_EQ(crossings_at(box, 6, {14, 14, 14}), (std::vector{10.5, 18.5}));
}

TEST(LineSpans, LineThroughCornersAndEdgesCrossesInAndOut) {
  // Corners and edges lie on nodes: each line may count or not, but in and out must match, which scan checks.
  auto const box = shapes::box({10, 10, 10}, {20, 20, 20});
  for (int f = 0; f < kFamilies; ++f) {
    for (int k = 8; k <= 22; k += 2) EXPECT_EQ(crossings_at(box, f, {10, 10, k}).size() % 2, 0U);
  }
}

TEST(LineSpans, BoxesThatFillARowCountEachLineOnce) {
  // Faces in common lie on lines: a line belongs to one box only.
  auto const left = shapes::box({10, 10, 10}, {14, 20, 20});
  auto const right = shapes::box({14, 10, 10}, {20, 20, 20});
  LatticeNode const shared{14, 14, 14};
  EXPECT_EQ(crossings_at(left, 1, shared).size() + crossings_at(right, 1, shared).size(), 2U);
  EXPECT_EQ(crossings_at(shapes::together(left, right), 0, shared).size(), 2U);
}

TEST(LineSpans, InsideOfAnotherShellIsNoCrossing) {
  auto const boxes = shapes::together(shapes::box({5.5, 5.5, 5.5}, {15.5, 25.5, 25.5}),
                                      shapes::box({9.5, 7.5, 7.5}, {21.5, 20.5, 20.5}));
  EXPECT_EQ(crossings_at(boxes, 0, {14, 14, 14}), (std::vector{5.5, 21.5}));
}

TEST(LineSpans, CutTakesAwayWhatLiesBelow) {
  LineSpans spans(kLattice, 2);
  ASSERT_TRUE(spans.scan(laid_out(shapes::box({5.5, 5.5, 5.5}, {15.5, 15.5, 25.5}))).has_value());
  spans.cut_below(8.5);
  auto const crossings = spans.crossings(spans.line({10, 10, 10}));
  ASSERT_EQ(crossings.size(), 2U);
  EXPECT_EQ(crossings[0].at, 8.5);
  EXPECT_EQ(crossings[0].triangle, -1);
  EXPECT_EQ(crossings[1].at, 25.5);
}

}  // namespace
}  // namespace inkflate
