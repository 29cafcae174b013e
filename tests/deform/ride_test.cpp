// SPDX-License-Identifier: Apache-2.0
#include "deform/ride.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "deform/body_mesh.h"
#include "geometry/affine.h"
#include "geometry/trig.h"
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

TEST(MotionField, IsExactlyZeroWhereNothingHasMoved) {
  auto const shape = bar(400, 40);
  auto pose = shape.mesh.rest.points;
  for (auto& p : pose) p.x += p.x > 300 ? 7 : 0;
  auto const motions = MotionField(shape.mesh).motions(pose);
  for (std::size_t v = 0; v < pose.size(); ++v) {
    if (pose[v].x > 270) continue;
    EXPECT_EQ(motions[v].shift, Vec2{});
    EXPECT_EQ(motions[v].change.x, Vec2{});
    EXPECT_EQ(motions[v].change.y, Vec2{});
  }
}

TEST(MotionField, IsTheMapOfAnAffinePose) {
  auto const shape = bar(400, 40);
  Affine const map = {1.2, 0.3, -0.4, 0.9, 50, -7};
  auto const motions = MotionField(shape.mesh).motions(posed(shape.mesh.rest.points, [&](Vec2 p) {
    return map(p);
  }));
  for (auto const& motion : motions) {
    EXPECT_LT(distance(motion.change.x, {0.2, 0.3}), 1e-9);
    EXPECT_LT(distance(motion.change.y, {-0.4, -0.1}), 1e-9);
  }
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
  for (int i = 0; i <= 20000; ++i) line.push_back({150 + i * 0.001, -1 - i * 0.004});
  auto const moved = ridden(shape, line, posed(shape.mesh.rest.points, bend));
  for (std::size_t i = 0; i + 1 < moved.size(); ++i)
    EXPECT_LT(distance(moved[i], moved[i + 1]), 0.03) << i;
}

}  // namespace
}  // namespace inkflate
