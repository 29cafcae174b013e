// SPDX-License-Identifier: Apache-2.0
#include "deform/ride.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "deform/body_mesh.h"
#include "geometry/affine.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

using support::arc_map;
using support::posed;

ShapeMesh bar(double length, double width) {
  std::vector<Outline> const outlines = {support::bar_outline(length, width)};
  return *body_mesh(outlines, 1);
}

/// Where places of a shape are in a pose.
std::vector<Vec2> ridden(ShapeMesh const& shape, std::vector<Vec2> const& points,
                         BendPose const& pose) {
  RidePlaces places(shape);
  auto const motions = MotionField(shape.mesh).motions(pose);
  std::vector<Vec2> result;
  for (auto const p : points) result.push_back(p + places.shift(motions, places.add(p)));
  return result;
}

std::vector<Vec2> random_places(int count) {
  Rng rng(11);
  std::vector<Vec2> places;
  for (int i = 0; i < count; ++i) places.push_back({rng.uniform(-100, 500), rng.uniform(-60, 100)});
  return places;
}

TEST(Ride, FollowsAnAffineMapInsideAndOutside) {
  auto const shape = bar(400, 40);
  Affine const map = {1.2, 0.3, -0.4, 0.9, 50, -7};
  auto const points = random_places(500);
  auto const moved =
      ridden(shape, points, posed(shape.mesh.rest.points, [&](Vec2 p) { return map(p); }));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT(distance(moved[i], map(points[i])), 1e-9);
}

TEST(Ride, FollowsAnAffineMapHoweverFarOutside) {
  auto const shape = bar(400, 40);
  Affine const map = {1.2, 0.3, -0.4, 0.9, 50, -7};
  std::vector<Vec2> points;
  for (double far = 1; far < 1e6; far *= 1.7) {
    points.push_back({-far, 20});
    points.push_back({200 + far / 2, 40 + far});
  }
  auto const moved =
      ridden(shape, points, posed(shape.mesh.rest.points, [&](Vec2 p) { return map(p); }));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT(distance(moved[i], map(points[i])), 1e-8) << i;
}

TEST(Ride, MakesAnArcOfAStraightLine) {
  auto const shape = bar(400, 40);
  auto const bend = arc_map(400, 20, 2);
  std::vector<Vec2> line;
  for (int i = 0; i <= 800; ++i) line.push_back({i * 0.5, 11});
  auto const moved = ridden(shape, line, posed(shape.mesh.rest.points, bend));
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_LT(distance(moved[i], bend(line[i])), 0.01) << i;
}

TEST(Ride, CarriesWhatIsALittleOutsideAsIfItWereInside) {
  auto const shape = bar(400, 40);
  auto const bend = arc_map(400, 20, 2);
  std::vector<Vec2> line;
  for (int i = 20; i <= 380; ++i) line.push_back({i * 1.0, 43});
  auto const moved = ridden(shape, line, posed(shape.mesh.rest.points, bend));
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_LT(distance(moved[i], bend(line[i])), 0.1) << i;
}

TEST(Ride, HasNoJumpAtTheRim) {
  auto const shape = bar(400, 40);
  auto const bend = arc_map(400, 20, 2);
  std::vector<Vec2> pairs;
  for (int i = 1; i < 400; ++i) {
    pairs.push_back({i + 0.3, 1e-7});
    pairs.push_back({i + 0.3, -1e-7});
  }
  auto const moved = ridden(shape, pairs, posed(shape.mesh.rest.points, bend));
  for (std::size_t i = 0; i < moved.size(); i += 2)
    EXPECT_LT(distance(moved[i], moved[i + 1]), 1e-6);
}

TEST(Ride, HasNoJumpOutside) {
  auto const shape = bar(400, 40);
  auto const bend = arc_map(400, 20, 2);
  std::vector<Vec2> line;
  // Beside a line, then among all that is near, then among ever fewer points of it.
  for (int i = 0; i <= 60000; ++i) line.push_back({150 + i * 0.001, -1 - i * 0.004});
  auto const moved = ridden(shape, line, posed(shape.mesh.rest.points, bend));
  for (std::size_t i = 0; i + 1 < moved.size(); ++i)
    EXPECT_LT(distance(moved[i], moved[i + 1]), 0.03) << i;
}

}  // namespace
}  // namespace inkflate
