// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/hash.h"
#include "geometry/trig.h"
#include "mesh/dynamic_triangulation.h"
#include "pipeline/place_sketch.h"
#include "simplify/simplify.h"
#include "support/regions.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr double kDegree = kPi / 180;

/// Points, triangles and their order.
std::uint64_t hash_of(FlatMesh const& mesh) {
  Hash hash;
  for (auto const p : mesh.points) {
    hash.add(p.x);
    hash.add(p.y);
  }
  for (auto const& t : mesh.triangles) {
    for (int const v : t) hash.add(std::int64_t{v});
  }
  return hash.value();
}

double longest_edge(FlatMesh const& mesh) {
  double longest = 0;
  for (auto const& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, distance(mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]));
  }
  return longest;
}

Error error_of(Region const& region) {
  auto const mesh = mesh_region(region);
  EXPECT_FALSE(mesh.has_value());
  return mesh ? Error{} : mesh.error();
}

TEST(MeshRegion, EveryLawHoldsOnEveryShape) {
  for (auto const& [name, region] : sample_regions()) {
    auto const mesh = mesh_region(region);
    ASSERT_TRUE(mesh.has_value()) << name << ": " << mesh.error().message;
    EXPECT_EQ(what_is_wrong(region, *mesh), "") << name;
  }
}

TEST(MeshRegion, EveryLawHoldsOnRandomPolygons) {
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    auto const region = random_region(seed);
    auto const mesh = mesh_region(region);
    EXPECT_EQ(mesh ? what_is_wrong(region, *mesh) : "", "") << "seed " << seed;
    refused += mesh ? 0 : 1;
  }
  EXPECT_LT(refused, 100);
}

TEST(MeshRegion, EveryLawHoldsOnWhatSimplifyMakes) {
  int layers = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto const sketch = place_sketch(random_sketch(seed), {1000.0, PlaceMode::FitStrokes});
    auto const drawing = sketch ? simplify(*sketch) : sketch.error();
    if (!drawing) continue;
    for (auto const& layer : drawing->layers) {
      auto const region = region_of(layer);
      auto const mesh = mesh_region(region);
      ASSERT_TRUE(mesh.has_value()) << "seed " << seed << ": " << mesh.error().message;
      EXPECT_EQ(what_is_wrong(region, *mesh), "") << "seed " << seed;
      ++layers;
    }
  }
  EXPECT_GT(layers, 10);
}

TEST(MeshRegion, NoAngleIsSmallAwayFromSharpCorners) {
  for (auto const& region : {disc_region(100, 5), disc_region(40, 1), annulus_region(100, 70, 4),
                             l_region(120, 5), comb_region(6, 6, 1.5), seamed_region(5)}) {
    auto const mesh = mesh_region(region);
    ASSERT_TRUE(mesh.has_value());
    EXPECT_GT(least_angle_rad(region, *mesh, 5), 20 * kDegree);
  }
}

TEST(MeshRegion, EveryCircleOfTheInsideIsEmpty) {
  auto const region = l_region(120, 5);
  auto const mesh = mesh_region(region);
  ASSERT_TRUE(mesh.has_value());
  auto const& points = mesh->mesh.points;
  int const rim_count = static_cast<int>(mesh->contours[0].size());
  int inside = 0;
  for (auto const& [a, b, c] : mesh->mesh.triangles) {
    // At the rim circles may hold points, as edges between two of its points are not allowed.
    if (std::min({a, b, c}) < rim_count) continue;
    ++inside;
    for (auto const p : points)
      EXPECT_FALSE(DynamicTriangulation::is_in_circle(points[a], points[b], points[c], p));
  }
  EXPECT_GT(inside, 50);
}

TEST(MeshRegion, EdgesGrowFromTheRimToTheLongest) {
  auto const region = disc_region(100, 3);
  auto const mesh = mesh_region(region, {.longest_px = 12, .growth = 0.3});
  ASSERT_TRUE(mesh.has_value());
  double nearest = 100;
  for (std::size_t i = mesh->contours[0].size(); i < mesh->mesh.points.size(); ++i)
    nearest = std::min(nearest, 100 - distance(mesh->mesh.points[i], {100, 100}));
  EXPECT_GT(nearest, 1.5);
  EXPECT_LT(nearest, 3.5);
  EXPECT_LT(longest_edge(mesh->mesh), 12 * 1.6);
  EXPECT_GT(longest_edge(mesh->mesh), 12 * 0.8);
}

TEST(MeshRegion, HalfTheLengthGivesFourTimesTheVertices) {
  auto const coarse = mesh_region(disc_region(100, 8), {.longest_px = 8});
  auto const fine = mesh_region(disc_region(100, 4), {.longest_px = 4});
  ASSERT_TRUE(coarse && fine);
  double const ratio = static_cast<double>(fine->mesh.points.size()) /
                       static_cast<double>(coarse->mesh.points.size());
  EXPECT_NEAR(ratio, 4, 0.6);
}

TEST(MeshRegion, AMeshIsNeverLargerThanItsLimit) {
  Region const huge = {{{{0, 0}, {9e5, 0}, {9e5, 9e5}, {0, 1e-3}}}, {}};
  auto const mesh = mesh_region(huge, {.longest_px = 1e-3, .growth = 1e-3});
  ASSERT_TRUE(mesh.has_value());
  EXPECT_LT(mesh->mesh.points.size(), 250000U);
}

TEST(MeshRegion, AFarAwayRegionIsMeshedAsOneAtTheOrigin) {
  auto region = l_region(1e-3, 2e-5);
  for (auto& p : region.contours[0]) p += Vec2{-9e5, 7e5};
  auto const mesh = mesh_region(region, {.longest_px = 1e-4});
  ASSERT_TRUE(mesh.has_value());
  // The lattice of doubles is there 1e-10 wide, so the area is not that exact.
  EXPECT_GT(mesh->mesh.points.size(), region.contours[0].size());
}

TEST(MeshRegion, TheSameEverywhere) {
  Hash all;
  for (auto const& sample : sample_regions()) {
    auto const mesh = mesh_region(sample.region);
    ASSERT_TRUE(mesh.has_value());
    all.add(static_cast<std::int64_t>(hash_of(mesh->mesh)));
  }
  EXPECT_EQ(all.value(), 1133164938855017480U);
}

TEST(MeshRegion, TheWayRoundAContourDoesNotMatter) {
  auto region = annulus_region(50, 20, 4);
  for (auto& contour : region.contours) std::reverse(contour.begin(), contour.end());
  auto const mesh = mesh_region(region);
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(what_is_wrong(region, *mesh), "");
}

TEST(MeshRegion, RefusesWhatCrossesOrTouches) {
  Contour const square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(error_of({{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}, {}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{square, {{5, 5}, {15, 5}, {5, 7}}}, {}}).index, 1);
  EXPECT_EQ(error_of({{square, {{0, 5}, {4, 5}, {4, 6}}}, {}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{square, {{10, 10}, {4, 5}, {4, 6}}}, {}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{square}, {{{2, 2}, {12, 2}}}}).index, 0);
  EXPECT_EQ(error_of({{square}, {{{2, 2}, {8, 2}}, {{5, 1}, {5, 2}}}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{square}, {{{2, 2}, {8, 2}, {2, 2}}}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{square}, {{{2, 2}, {8, 2}, {5, 2}}}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{{{0, 0}, {10, 0}, {10, 10}, {10, 0}}}, {}}).code, ErrorCode::BadInput);
}

TEST(MeshRegion, RefusesWhatDoesNotLieInside) {
  Contour const square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  Contour const beside = {{20, 0}, {30, 0}, {30, 10}};
  Contour const within = {{2, 2}, {8, 2}, {8, 8}};
  EXPECT_EQ(error_of({{square, beside}, {}}).index, 1);
  EXPECT_EQ(error_of({{within, square}, {}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{square, within, {{6, 4}, {7, 4}, {7, 5}}}, {}}).index, 2);
  EXPECT_EQ(error_of({{square}, {{{12, 2}, {14, 2}}}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{square, within}, {{{6, 4}, {7, 4}}}}).code, ErrorCode::BadInput);
}

TEST(MeshRegion, RefusesTooFewAndUnusablePoints) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Contour const square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(error_of({}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{{{0, 0}, {1, 0}}}, {}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{square}, {{{1, 1}}}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{{{0, 0}, {1, nan}, {1, 1}}}, {}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{{{0, 0}, {2e6, 0}, {1, 1}}}, {}}).code, ErrorCode::BadInput);
  EXPECT_EQ(error_of({{{{0, 0}, {1, 1e-200}, {1, 1}}}, {}}).code, ErrorCode::BadInput);
}

}  // namespace
}  // namespace inkflate
