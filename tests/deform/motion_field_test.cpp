// SPDX-License-Identifier: Apache-2.0
#include "deform/motion_field.h"

#include <gtest/gtest.h>

#include "deform/body_mesh.h"
#include "geometry/affine.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

using support::posed;

ShapeMesh bar(double length, double width) {
  std::vector<Outline> const outlines = {support::bar_outline(length, width)};
  return *body_mesh(outlines, 1);
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

TEST(MotionField, ChangesAlongALineAsItsNeighboursThereTell) {
  auto const shape = bar(400, 40);
  auto const& rest = shape.mesh.rest.points;
  auto const pose = posed(rest, support::arc_map(400, 20, 2));
  auto const motions = MotionField(shape.mesh).motions(pose);
  auto const& line = shape.mesh.lines.front().vertices;
  int straight = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    Vec2 const chord = rest[line[i + 1]] - rest[line[i - 1]];
    // The corners of the bar have neighbours on two sides.
    if (chord.x * chord.y != 0) continue;
    Vec2 const bent = pose[line[i + 1]] - pose[line[i - 1]];
    EXPECT_LT(distance(chord + motions[line[i]].change(chord), bent), 1e-9);
    ++straight;
  }
  EXPECT_GT(straight, 300);
}

TEST(MotionField, TellsNothingAlongALineThatTurnsBack) {
  // A hairpin: the neighbours of its tip are 2 px apart, the way between them is 200 px.
  BendMesh mesh;
  mesh.rest.points = {{0, 0}, {100, 1}, {0, 2}, {100, 40}};
  mesh.rest.triangles = {{0, 1, 2}, {1, 3, 2}};
  mesh.stiffness = {1, 1};
  mesh.lines = {{{0, 1, 2}, false}};
  mesh.edge_px = 100;
  auto pose = mesh.rest.points;
  // Opened by 20 px: along that chord the shape would be ten times as long.
  pose[2].y += 20;
  auto const motions = MotionField(mesh).motions(pose);
  mesh.lines.clear();
  auto const without = MotionField(mesh).motions(pose);
  EXPECT_EQ(motions[1].change.y, without[1].change.y);
}

}  // namespace
}  // namespace inkflate
