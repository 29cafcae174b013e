// SPDX-License-Identifier: Apache-2.0
#include "solidify/solidify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/trig.h"
#include "mesh/check_mesh.h"
#include "support/solid_shapes.h"

namespace inkflate {
namespace {

using namespace shapes;

/// Made solid, printable, and measured.
struct Solidified {
  TriMesh mesh;
  MeshCheck check;
};

Solidified printable(TriMesh const& model, SolidifyOptions const& options) {
  auto result = solidify(model, options);
  EXPECT_TRUE(result.has_value()) << result.error().message;
  if (!result) return {};
  Solidified solid{std::move(*result), {}};
  solid.check = check_mesh(solid.mesh);
  EXPECT_TRUE(solid.check.is_sound());
  EXPECT_EQ(count_self_crossings(solid.mesh), 0);
  EXPECT_GT(least_angle(solid.mesh), 1);
  return solid;
}

ErrorCode failure(TriMesh const& model, SolidifyOptions const& options = {.cells = 16}) {
  auto const result = solidify(model, options);
  EXPECT_FALSE(result.has_value());
  return result ? ErrorCode::FileSystem : result.error().code;
}

double ball_volume(double radius) { return 4.0 / 3 * kPi * radius * radius * radius; }

TEST(Solidify, OverlappingBallsBecomeOneShellWithTheVolumeOfTheirUnion) {
  auto const solid =
      printable(together(sphere({0, 0, 0}, 30), sphere({40, 0, 0}, 30)), {.cells = 50});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_EQ(solid.check.genus, 0);
  // Two caps of height 10 are counted once too often.
  double const lens = 2 * kPi * 100 * (3 * 30 - 10) / 3;
  double const truth = 2 * ball_volume(30) - lens;
  EXPECT_NEAR(solid.check.volume, truth, 0.005 * truth);
}

TEST(Solidify, RingKeepsItsHole) {
  auto const solid = printable(torus(35, 15), {.cells = 40});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_EQ(solid.check.genus, 1);
}

double radius_error(int cells) {
  auto const solid = printable(sphere({0, 0, 0}, 50, 6), {.cells = cells});
  double worst = 0;
  for (auto const& [a, b, c] : solid.mesh.triangles) {
    auto const& p = solid.mesh.points;
    Vec3 const middle = (p[a] + p[b] + p[c]) / 3 - Vec3{0, 0, 50};
    worst = std::max(worst, std::abs(norm(middle) - 50));
  }
  return worst;
}

TEST(Solidify, RadiusErrorFallsWithTheSquareOfTheCells) {
  double const coarse = radius_error(16);
  double const fine = radius_error(32);
  EXPECT_LT(coarse, 0.05 * 100 / 16);
  EXPECT_LT(fine, coarse / 3);
}

TEST(Solidify, BoxKeepsItsSizeAndTurnsItsHeightUp) {
  auto const solid = printable(box({0, 0, 0}, {50, 100, 25}), {.cells = 40});
  EXPECT_NEAR(solid.check.volume, 50 * 100 * 25, 0.01 * 50 * 100 * 25);
  EXPECT_NEAR(solid.check.max.x - solid.check.min.x, 50, 0.01);
  EXPECT_NEAR(solid.check.max.y - solid.check.min.y, 25, 0.01);
  EXPECT_NEAR(solid.check.max.z, 100, 0.01);
  EXPECT_EQ(solid.check.min.z, 0);
}

TEST(Solidify, FrontFacesMinusY) {
  // A ball with a nose on the right half of its front.
  auto const solid =
      printable(together(sphere({0, 0, 0}, 30), sphere({10, 0, 30}, 10)), {.cells = 40});
  auto const lowest = std::min_element(solid.mesh.points.begin(), solid.mesh.points.end(),
                                       [](Vec3 a, Vec3 b) { return a.y < b.y; });
  EXPECT_NEAR(lowest->x, 10 * 100.0 / 70, 1);
}

TEST(Solidify, LongestSideIsAsWished) {
  auto const solid = printable(capsule({0, 0, 0}, {3, 1, 2}, 1), {.longest_mm = 60, .cells = 40});
  auto const size = solid.check.max - solid.check.min;
  EXPECT_NEAR(std::max({size.x, size.y, size.z}), 60, 0.2);
}

/// How thick the solid is along the y axis at a place of its front.
double thickness_at(TriMesh const& mesh, double x, double z) {
  double least = 1e300;
  double most = -1e300;
  for (auto const& [ia, ib, ic] : mesh.triangles) {
    Vec3 const a = mesh.points[ia];
    Vec3 const b = mesh.points[ib];
    Vec3 const c = mesh.points[ic];
    auto const turn = [&](Vec3 p, Vec3 q) {
      return (q.x - p.x) * (z - p.z) - (q.z - p.z) * (x - p.x);
    };
    double const wa = turn(b, c);
    double const wb = turn(c, a);
    double const wc = turn(a, b);
    bool const is_met = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
    if (!is_met || wa + wb + wc == 0) continue;
    double const y = (wa * a.y + wb * b.y + wc * c.y) / (wa + wb + wc);
    least = std::min(least, y);
    most = std::max(most, y);
  }
  return most - least;
}

TEST(Solidify, ThinPlateGrowsToTheLeastThickness) {
  auto const solid =
      printable(box({0, 0, 0}, {40, 40, 0.2}), {.longest_mm = 40, .least_mm = 3, .cells = 40});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_EQ(solid.check.genus, 0);
  for (double const x : {-15.0, -3.3, 0.1, 12.0}) {
    for (double const z : {5.2, 20.0, 33.0}) {
      EXPECT_GT(thickness_at(solid.mesh, x, z), 2.9);
      EXPECT_LT(thickness_at(solid.mesh, x, z), 3.1);
    }
  }
}

TEST(Solidify, ThickPlaceStaysWhatItWas) {
  auto const ball = sphere({0, 0, 0}, 20);
  auto const plain = printable(ball, {.least_mm = 0, .cells = 32});
  auto const thick = printable(ball, {.least_mm = 5, .cells = 32});
  EXPECT_NEAR(thick.check.volume, plain.check.volume, 1e-3 * plain.check.volume);
}

TEST(Solidify, SheetWithoutThicknessBecomesAPlate) {
  TriMesh sheet;
  sheet.points = {{0, 0, 0}, {40, 0, 0}, {40, 30, 0}, {0, 30, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  auto const solid = printable(sheet, {.longest_mm = 40, .least_mm = 2, .cells = 40});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_NEAR(thickness_at(solid.mesh, 0.3, 15.2), 2, 0.1);
}

TEST(Solidify, FlatBaseLiesOnZero) {
  auto const model = together(sphere({0, 0, 0}, 30), sphere({0, 40, 0}, 20));
  auto const solid = printable(model, {.has_flat_base = true, .cells = 40});
  EXPECT_EQ(solid.check.min.z, 0);
  // A ball of radius 100 / 3 is cut at a height of 3.
  double const truth = kPi * 3 * (200.0 / 3 - 3);
  double area = 0;
  for (auto const& [a, b, c] : solid.mesh.triangles) {
    auto const& p = solid.mesh.points;
    if (p[a].z == 0 && p[b].z == 0 && p[c].z == 0) area -= cross(p[b] - p[a], p[c] - p[a]).z / 2;
  }
  EXPECT_GT(area, 0.4 * truth);
  EXPECT_NEAR(solid.check.max.z, 97, 0.1);
}

TEST(Solidify, ShellInsideAnotherVanishes) {
  auto const solid =
      printable(together(sphere({0, 0, 0}, 50), sphere({10, 0, 0}, 10)), {.cells = 32});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_EQ(solid.check.genus, 0);
}

TEST(Solidify, ClosedVoidIsFilled) {
  auto const hollow = together(sphere({0, 0, 0}, 50), inside_out(sphere({0, 0, 0}, 30)));
  auto const solid = printable(hollow, {.cells = 32});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_NEAR(solid.check.volume, ball_volume(50), 0.01 * ball_volume(50));
}

TEST(Solidify, PiecesApartStayPieces) {
  auto const solid =
      printable(together(sphere({0, 0, 0}, 20), sphere({60, 0, 0}, 20)), {.cells = 32});
  EXPECT_EQ(solid.check.shells, 2);
}

TEST(Solidify, SlitNarrowerThanTheLatticeCloses) {
  auto const halves = together(box({0, 0, 0}, {40, 40, 40}), box({40.1, 0, 0}, {80, 40, 40}));
  auto const solid = printable(halves, {.cells = 40});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_EQ(solid.check.genus, 0);
}

TEST(Solidify, SlitThatTheLatticeShowsStaysOpen) {
  auto const halves = together(box({0, 0, 0}, {40, 40, 40}), box({45, 0, 0}, {80, 40, 40}));
  EXPECT_EQ(printable(halves, {.least_mm = 0, .cells = 40}).check.shells, 2);
}

TEST(Solidify, BoxesThatShareAFaceAreOne) {
  auto const boxes = together(box({0, 0, 0}, {40, 40, 40}), box({40, 0, 0}, {80, 40, 40}));
  auto const solid = printable(boxes, {.cells = 32});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_NEAR(solid.check.volume, 250000, 2500);
}

TEST(Solidify, ShellThatPassesThroughItselfIsOneSolid) {
  // A tube that runs around twice, crossing itself.
  auto const knot = wrapped(240, 32, [](double u, double v) -> Vec3 {
    auto const ring = sin_cos(4 * kPi * u);
    auto const wave = sin_cos(2 * kPi * u);
    auto const tube = sin_cos(2 * kPi * v);
    double const out = 30 + 8 * wave.cos + 8 * tube.cos;
    return {out * ring.cos, out * ring.sin, 8 * tube.sin};
  });
  auto const solid = printable(knot, {.cells = 60});
  EXPECT_EQ(solid.check.shells, 1);
  EXPECT_EQ(solid.check.genus, 1);
}

TEST(Solidify, SameInputGivesTheSameBits) {
  auto const model = together(sphere({0, 0, 0}, 30), capsule({0, 0, 0}, {50, 10, 5}, 5));
  EXPECT_EQ(*solidify(model, {.cells = 32}), *solidify(model, {.cells = 32}));
}

TEST(Solidify, ScaleOfTheModelDoesNotMatter) {
  auto model = together(sphere({0, 0, 0}, 30), capsule({0, 0, 0}, {50, 10, 5}, 5));
  auto const large = solidify(model, {.cells = 32});
  for (auto& point : model.points) point = point / 1024;
  EXPECT_EQ(*large, *solidify(model, {.cells = 32}));
}

TEST(Solidify, RefusesWhatIsNotClosed) {
  auto open = sphere({0, 0, 0}, 10);
  open.triangles.pop_back();
  EXPECT_EQ(failure(open), ErrorCode::BadInput);
  auto damaged = sphere({0, 0, 0}, 10);
  damaged.triangles[3][1] = 1 << 20;
  EXPECT_EQ(failure(damaged), ErrorCode::BadInput);
  auto lost = sphere({0, 0, 0}, 10);
  lost.points[5].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(failure(lost), ErrorCode::BadInput);
}

TEST(Solidify, RefusesNothing) {
  EXPECT_EQ(failure({}), ErrorCode::NothingThere);
  TriMesh point;
  point.points.assign(3, {1, 1, 1});
  point.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(failure(point), ErrorCode::NothingThere);
}

TEST(Solidify, RefusesOptionsOutOfRange) {
  auto const ball = sphere({0, 0, 0}, 10);
  EXPECT_EQ(failure(ball, {.longest_mm = 4}), ErrorCode::BadOption);
  EXPECT_EQ(failure(ball, {.least_mm = -1}), ErrorCode::BadOption);
  EXPECT_EQ(failure(ball, {.longest_mm = 20, .least_mm = 11}), ErrorCode::BadOption);
  EXPECT_EQ(failure(ball, {.cells = 15}), ErrorCode::BadOption);
  EXPECT_EQ(failure(ball, {.longest_mm = std::nan("")}), ErrorCode::BadOption);
}

TEST(Solidify, RefusesWhatNeedsTooMuchMemory) {
  EXPECT_EQ(failure(box({0, 0, 0}, {1, 1, 1}), {.cells = 512}), ErrorCode::TooLarge);
}

TEST(Solidify, StopsWhenCancelled) {
  int entered = 0;
  Progress progress;
  progress.report = [&](std::string_view) { ++entered; };
  progress.is_cancelled = [&] { return entered == 4; };
  auto const result = solidify(sphere({0, 0, 0}, 10), {.cells = 16}, progress);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace inkflate
