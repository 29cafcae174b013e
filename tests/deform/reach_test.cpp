// SPDX-License-Identifier: Apache-2.0
#include "deform/reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "deform/body_solver.h"
#include "geometry/trig.h"
#include "mesh/mesh_region.h"
#include "support/bend_meshes.h"
#include "support/regions.h"

namespace inkflate {
namespace {

FlatMesh meshed(Region const& region) { return mesh_region(region)->mesh; }

/// The first triangle with the vertex nearest to p, and its corner.
BendAnchor anchor_at(FlatMesh const& mesh, Vec2 p) {
  int best = 0;
  for (int v = 0; v < std::ssize(mesh.points); ++v) {
    if (distance(mesh.points[v], p) < distance(mesh.points[best], p)) best = v;
  }
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.triangles[t][k] != best) continue;
      BendAnchor anchor = {t, {0, 0, 0}};
      anchor.weights[k] = 1;
      return anchor;
    }
  }
  return {};
}

TEST(Reach, IsTheStraightWayWhereNothingIsBetween) {
  auto const mesh = meshed(disc_region(200, 8));
  BendAnchor const from = {static_cast<int>(mesh.triangles.size() / 3), {0.2, 0.5, 0.3}};
  Vec2 const source = place_of(mesh, mesh.points, from);
  auto const ways = ways_inside(mesh, from);
  for (std::size_t v = 0; v < ways.size(); ++v)
    EXPECT_NEAR(ways[v], distance(source, mesh.points[v]), 1e-9);
}

TEST(Reach, GoesAroundTheCornerOfAnL) {
  auto const mesh = meshed(l_region(300, 8));
  auto const from = anchor_at(mesh, {0, 0});
  Vec2 const source = place_of(mesh, mesh.points, from);
  Vec2 const corner = {100, 200};
  auto const ways = ways_inside(mesh, from);
  int hidden = 0;
  for (std::size_t v = 0; v < ways.size(); ++v) {
    Vec2 const p = mesh.points[v];
    bool const is_hidden = p.x > corner.x && cross(corner - source, p - corner) < 0;
    double const wanted =
        is_hidden ? distance(source, corner) + distance(corner, p) : distance(source, p);
    EXPECT_NEAR(ways[v], wanted, 0.02 * wanted + 1e-9) << p.x << " " << p.y;
    hidden += is_hidden ? 1 : 0;
  }
  EXPECT_GT(hidden, 20);
}

TEST(Reach, GoesAroundAHoleAlongItsRim) {
  auto const mesh = meshed(annulus_region(200, 100, 6));
  auto const from = anchor_at(mesh, {400, 200});
  Vec2 const source = place_of(mesh, mesh.points, from);
  auto const ways = ways_inside(mesh, from);
  for (std::size_t v = 0; v < ways.size(); ++v) {
    Vec2 const p = mesh.points[v];
    if (distance(p, {0, 200}) > 3) continue;
    // Both tangents, and the arc between them.
    double const tangent = std::sqrt(200.0 * 200 - 100.0 * 100);
    double const wanted = 2 * tangent + 100 * (kPi - 2 * acos_of(0.5));
    EXPECT_NEAR(ways[v], wanted, 0.02 * wanted);
    EXPECT_GT(ways[v], distance(source, p));
  }
}

TEST(Reach, IsNeverShorterThanTheStraightWay) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto const region = mesh_region(random_region(seed));
    if (!region) continue;
    auto const& mesh = region->mesh;
    auto const ways = ways_inside(mesh, {0, {1, 0, 0}});
    Vec2 const source = mesh.points[mesh.triangles[0][0]];
    for (std::size_t v = 0; v < ways.size(); ++v)
      EXPECT_GE(ways[v], distance(source, mesh.points[v]) - 1e-9);
  }
}

TEST(Reach, IsInfiniteToOtherParts) {
  FlatMesh const mesh = {{{0, 0}, {1, 0}, {0, 1}, {5, 5}, {6, 5}, {5, 6}}, {{0, 1, 2}, {3, 4, 5}}};
  auto const ways = ways_inside(mesh, {0, {1, 0, 0}});
  EXPECT_EQ(ways[0], 0);
  EXPECT_EQ(ways[1], 1);
  EXPECT_EQ(ways[4], std::numeric_limits<double>::infinity());
}

TEST(StiffeningWithin, GrowsTowardsTheEndOfTheReachAndStaysSoBeyond) {
  // Three triangles in a row, at 0, 80 and 200 px.
  FlatMesh mesh;
  std::vector<double> ways_px;
  for (double const way : {0.0, 80.0, 200.0}) {
    int const first = static_cast<int>(std::ssize(mesh.points));
    mesh.points.insert(mesh.points.end(), {{way, 0}, {way + 1, 0}, {way, 1}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    ways_px.insert(ways_px.end(), 3, way);
  }
  auto const stiffening = stiffening_within(mesh, ways_px, 100);
  ASSERT_EQ(stiffening.size(), 3);
  EXPECT_EQ(stiffening[0], 1);
  EXPECT_GT(stiffening[1], 1);
  EXPECT_GT(stiffening[2], stiffening[1]);
  EXPECT_EQ(stiffening_within(mesh, ways_px, 200)[2], stiffening[2]);
}

TEST(TethersWithin, GrowFromHalfOfTheReachToItsEndAndHoldNothingBeyond) {
  auto const mesh = support::bar_mesh(400, 40, 40, 4);
  auto const ways = ways_inside(mesh.rest, support::anchor_near(mesh, {0, 0}));
  auto const tethers = tethers_within(mesh, ways, 300);
  // Inside the bar each vertex stands for as much of it: 10 x 10 px.
  double before = 0;
  for (int x = 10; x < 400; x += 10) {
    double const tether = tethers[support::nearest_vertex(mesh.rest, {1.0 * x, 0})];
    if (x <= 150 || x > 300) {
      EXPECT_EQ(tether, 0) << x;
    } else {
      EXPECT_GT(tether, before) << x;
      before = tether;
    }
  }
}

TEST(TethersWithin, HoldADrawingOfAnotherSizeAlike) {
  auto mesh = support::bar_mesh(400, 40, 40, 4);
  auto const from = support::anchor_near(mesh, {0, 0});
  auto const tethers = tethers_within(mesh, ways_inside(mesh.rest, from), 300);
  for (auto& p : mesh.rest.points) p = p * 8;
  EXPECT_EQ(tethers_within(mesh, ways_inside(mesh.rest, from), 2400), tethers);
}

constexpr double kReachPx = 480;

/// What holds the bar when its tip is dragged.
struct Held {
  BendMesh mesh = support::bar_mesh(800, 100, 160, 20);
  BendAnchor tip = support::anchor_near(mesh, {800, 0});
  std::vector<double> ways = ways_inside(mesh.rest, tip);
  std::vector<char> is_fixed = {};
  std::vector<double> stiffening = {};
  std::vector<double> tethers = {};

  explicit Held(double reach_px) {
    for (double const px : ways) is_fixed.push_back(px > reach_px ? 1 : 0);
  }

  /// Its tip goes there and the bar comes to rest.
  void drag(BendPose& pose, Vec2 to) const {
    BodySolver solver(mesh);
    BendHandle const handle = {tip, to, {}, 28};
    solver.step(pose, {{&handle, 1}, is_fixed, stiffening, tethers, mesh.rest.points}, 60);
  }

  /// By how much a side of the bar turns within 30 px at most, but next to the hand; degrees.
  double sharpest_turn(BendPose const& pose) const {
    double most = 0;
    for (double const y : {-50.0, 50.0}) {
      auto const place = [&](int x) {
        return pose[support::nearest_vertex(mesh.rest, {1.0 * x, y})];
      };
      for (int x = 100; x < 700; x += 5) {
        Vec2 const before = normalized(place(x - 10) - place(x - 15));
        Vec2 const after = normalized(place(x + 15) - place(x + 10));
        most = std::max(most, acos_of(dot(before, after)) * 180 / kPi);
      }
    }
    return most;
  }
};

TEST(TethersWithin, BendInARoundWhatIsDraggedAsFarAsItFollowsFreely) {
  Held soft(kReachPx);
  soft.tethers = tethers_within(soft.mesh, soft.ways, kReachPx);
  Held stiff(kReachPx / 2);
  stiff.stiffening = stiffening_within(stiff.mesh.rest, stiff.ways, kReachPx / 2);
  for (double const far : {0.6, 1.0, 1.5}) {
    Vec2 const to = {800, -far * kReachPx / 2};
    auto round = soft.mesh.rest.points;
    soft.drag(round, to);
    auto kinked = stiff.mesh.rest.points;
    stiff.drag(kinked, to);
    EXPECT_LT(2 * soft.sharpest_turn(round), stiff.sharpest_turn(kinked)) << far;
    EXPECT_LT(soft.sharpest_turn(round), 15) << far;
  }
}

TEST(TethersWithin, LetGoOfNothingThatIsDraggedBack) {
  Held soft(kReachPx);
  soft.tethers = tethers_within(soft.mesh, soft.ways, kReachPx);
  auto pose = soft.mesh.rest.points;
  soft.drag(pose, {760, -200});
  EXPECT_GT(support::largest_distance(pose, soft.mesh.rest.points), 100);
  soft.drag(pose, {800, 0});
  EXPECT_LT(support::largest_distance(pose, soft.mesh.rest.points), 1e-4);
}

}  // namespace
}  // namespace inkflate
