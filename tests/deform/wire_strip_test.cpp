// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_strip.h"

#include <gtest/gtest.h>

#include <numeric>

#include "geometry/trig.h"

namespace inkflate {
namespace {

Contour circle(int count, double radius_px) {
  Contour contour;
  for (int i = 0; i < count; ++i) {
    auto const [sin, cos] = sin_cos(2 * kPi * i / count);
    contour.push_back({radius_px * cos, radius_px * sin});
  }
  return contour;
}

std::vector<double> areas(FlatMesh const& mesh) {
  std::vector<double> result;
  for (auto const& [a, b, c] : mesh.triangles)
    result.push_back(cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]) / 2);
  return result;
}

TEST(WireStrip, HasThreeVerticesAndFourTrianglesForEachPoint) {
  std::vector<Contour> const contours = {circle(40, 100), circle(7, 20)};
  auto const mesh = wire_strip(contours, 5);
  EXPECT_EQ(std::ssize(mesh.rest.points), 3 * 47);
  EXPECT_EQ(std::ssize(mesh.rest.triangles), 4 * 47);
  EXPECT_EQ(mesh.stiffness, std::vector<double>(4 * 47, 1));
  ASSERT_EQ(std::ssize(mesh.lines), 2);
  EXPECT_EQ(mesh.lines[1].vertices.front(), 3 * 40);
  EXPECT_TRUE(mesh.lines[1].is_closed);
}

TEST(WireStrip, OfAnOpenLineHasFourTrianglesForEachSegment) {
  std::vector<Polyline> const lines = {{{0, 0}, {10, 0}, {20, 5}}};
  auto const mesh = open_wire_strip(lines, 2);
  EXPECT_EQ(std::ssize(mesh.rest.points), 9);
  EXPECT_EQ(std::ssize(mesh.rest.triangles), 8);
  EXPECT_FALSE(mesh.lines[0].is_closed);
  EXPECT_EQ(mesh.rest.points[3], (Vec2{0, -2}));
  EXPECT_EQ(mesh.rest.points[6], (Vec2{0, 2}));
}

TEST(WireStrip, ConnectsVerticesAsInTheThesis) {
  std::vector<Contour> const contours = {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  auto const& triangles = wire_strip(contours, 2).rest.triangles;
  auto const is_of = [&](int row, Triangle corners) {
    auto mine = triangles[row];
    std::sort(mine.begin(), mine.end());
    std::sort(corners.begin(), corners.end());
    return mine == corners;
  };
  for (int i = 0; i < 4; ++i) {
    int const next = (i + 1) % 4;
    EXPECT_TRUE(is_of(i, {i, i + 4, next}));
    EXPECT_TRUE(is_of(i + 4, {i + 4, next, next + 4}));
    EXPECT_TRUE(is_of(i + 8, {i, i + 8, next + 8}));
    EXPECT_TRUE(is_of(i + 12, {i, next, next + 8}));
  }
}

TEST(WireStrip, LiesAtItsHalfWidthAboveAndBelowAlongTheMeanNormal) {
  std::vector<Contour> const contours = {circle(60, 100)};
  auto const mesh = wire_strip(contours, 7);
  for (int i = 0; i < 60; ++i) {
    EXPECT_NEAR(norm(mesh.rest.points[i + 60]), 107, 1e-9);
    EXPECT_NEAR(norm(mesh.rest.points[i + 120]), 93, 1e-9);
  }
}

TEST(WireStrip, WithoutAWidthIsAsWideAsTheMeanEdge) {
  std::vector<Contour> const contours = {circle(60, 100)};
  auto const mesh = wire_strip(contours, 0);
  double const edge_px = perimeter(contours[0]) / 60;
  EXPECT_NEAR(distance(mesh.rest.points[60], mesh.rest.points[0]), edge_px, 1e-9);
  EXPECT_NEAR(mesh.edge_px, edge_px, 1e-9);
}

TEST(WireStrip, TrianglesOfASmoothLineTileTheBand) {
  std::vector<Contour> const contours = {circle(200, 100)};
  auto const all = areas(wire_strip(contours, 5).rest);
  for (double const area : all) EXPECT_GT(area, 0);
  EXPECT_NEAR(std::accumulate(all.begin(), all.end(), 0.0),
              100 * sin_cos(2 * kPi / 200).sin * (105 * 105 - 95 * 95), 1e-6);
}

TEST(WireStrip, BearsSpikesHairpinsAndCoincidentPoints) {
  std::vector<Contour> const contours = {
      {{0, 0}, {100, 0}, {0, 0.001}},                 // a spike
      {{0, 0}, {50, 0}, {100, 0}, {50, 0}},           // there and back
      {{0, 0}, {0, 0}, {10, 0}, {10, 10}, {10, 10}},  // double points
      {{5, 5}, {5, 5}, {5, 5}},
      {{0, 0}, {1, 0}},
      {{3, 3}},
      {}};
  for (double const half_width_px : {0.0, 1.0, 500.0}) {
    auto const mesh = wire_strip(contours, half_width_px);
    EXPECT_EQ(std::ssize(mesh.rest.points), 3 * (3 + 4 + 5 + 3 + 2 + 1));
    for (auto const p : mesh.rest.points) EXPECT_TRUE(is_finite(p));
    for (double const area : areas(mesh.rest)) EXPECT_GE(area, 0);
    EXPECT_GT(mesh.edge_px, 0);
  }
}

TEST(WireStrip, HasTrianglesWithAreaWhereALineTurnsBack) {
  std::vector<Contour> const contours = {{{0, 0}, {50, 0}, {100, 0}, {50, 0}}};
  for (double const area : areas(wire_strip(contours, 5).rest)) EXPECT_GT(area, 1);
}

}  // namespace
}  // namespace inkflate
