// SPDX-License-Identifier: Apache-2.0
#include "deform/line_anchors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/rng.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

/// How far the lines of a mesh are from a place, by many points of them.
double distance_to_lines(BendMesh const& mesh, BendPose const& pose, Vec2 place) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const& [vertices, is_closed] : mesh.lines) {
    for (std::size_t i = is_closed ? 0 : 1; i < vertices.size(); ++i) {
      Vec2 const from = pose[vertices[i == 0 ? vertices.size() - 1 : i - 1]];
      for (int k = 0; k <= 20; ++k)
        least = std::min(least, distance(lerp(from, pose[vertices[i]], k / 20.0), place));
    }
  }
  return least;
}

TEST(LineAnchors, AreThePlacesOfTheLinesThatAreNearestInThePose) {
  auto const shape = support::face_shape(200);
  auto const bender = support::made_bender(shape);
  auto const& mesh = bender.mesh();
  LineAnchors const anchors(mesh);
  auto const pose = support::posed(bender.rest_pose(), support::strong_bend(shape));
  Rng rng(5);
  for (int k = 0; k < 100; ++k) {
    Vec2 const place = {rng.uniform(-200, 600), rng.uniform(-200, 600)};
    auto const anchor = anchors.nearest(pose, place);
    double sum = 0;
    for (double const weight : anchor.weights) {
      EXPECT_GE(weight, 0);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    double const found_px = distance(place_of(mesh.rest, pose, anchor), place);
    double const least_px = distance_to_lines(mesh, pose, place);
    EXPECT_LE(found_px, least_px + 1e-9);
    EXPECT_GE(found_px, least_px - 0.5);  // half of what lies between two of those points
  }
}

TEST(LineAnchors, OfPlacesEquallyNearTheFirstIsTaken) {
  BendMesh mesh;
  mesh.rest.points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  mesh.rest.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.stiffness = {1, 1};
  mesh.lines = {{{0, 1, 2, 3}, true}};
  mesh.edge_px = 10;
  auto const anchor = LineAnchors(mesh).nearest(mesh.rest.points, {5, 5});
  EXPECT_EQ(place_of(mesh.rest, mesh.rest.points, anchor), (Vec2{5, 0}));
}

}  // namespace
}  // namespace inkflate
