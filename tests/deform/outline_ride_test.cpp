// SPDX-License-Identifier: Apache-2.0
#include "deform/outline_ride.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/trig.h"
#include "support/bend_shapes.h"
#include "support/extremes.h"

namespace inkflate {
namespace {

using namespace support;

TEST(OutlineRide, JoinsPiecesExactlyAndKeepsKindsAndPoints) {
  auto const shape = face_shape(200);
  for (auto const mode : kBendModes) {
    auto const bender = made_bender(shape, mode);
    auto const bent = bender.bent(posed(bender.rest_pose(), strong_bend(shape)));
    for (std::size_t o = 0; o < shape.outlines.size(); ++o) {
      auto const& pieces = bent.outlines.at(o).pieces;
      EXPECT_GE(pieces.size(), 4U);
      std::vector<RunKind> kinds;
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].curve.end(), pieces[(i + 1) % pieces.size()].curve.start());
        if (kinds.empty() || kinds.back() != pieces[i].kind) kinds.push_back(pieces[i].kind);
      }
      std::vector<RunKind> const wanted = {RunKind::Ink, RunKind::Closing, RunKind::HelpLine,
                                           RunKind::Ink};
      EXPECT_EQ(kinds, o == 0 ? wanted : std::vector<RunKind>{RunKind::Ink});
    }
    ASSERT_EQ(bent.lines.size(), shape.lines.size());
    for (std::size_t i = 0; i < shape.lines.size(); ++i)
      EXPECT_EQ(bent.lines[i].size(), shape.lines[i].size());
  }
}

Vec2 point_of(Outline const& outline, double parameter) {
  int const last = static_cast<int>(std::ssize(outline.pieces)) - 1;
  int const piece = std::min(last, static_cast<int>(parameter));
  return point_at(outline.pieces[piece].curve, parameter - piece);
}

TEST(OutlineRide, LeavesSourcesAtTheirPlacesOfTheOutline) {
  auto const shape = face_shape(200);
  auto const bend = strong_bend(shape);
  auto const bender = made_bender(shape);
  auto const bent = bender.bent(posed(bender.rest_pose(), bend));
  auto const& before = shape.outlines[0].sources;
  auto const& after = bent.outlines[0].sources;
  ASSERT_EQ(after.size(), before.size());
  EXPECT_GT(bent.outlines[0].pieces.size(), 4U);
  EXPECT_EQ(after[0].from, 0);
  EXPECT_EQ(after[0].to, after[1].from);
  EXPECT_EQ(after[2].to, static_cast<double>(bent.outlines[0].pieces.size()));
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].stroke, before[i].stroke);
    EXPECT_EQ(after[i].sample_from, before[i].sample_from);
    EXPECT_EQ(after[i].sample_to, before[i].sample_to);
    EXPECT_LT(distance(point_of(bent.outlines[0], after[i].from),
                       bend(point_of(shape.outlines[0], before[i].from))),
              0.1);
    EXPECT_LT(distance(point_of(bent.outlines[0], after[i].to),
                       bend(point_of(shape.outlines[0], before[i].to))),
              0.1);
  }
}

/// The largest turn between one piece and the next, rad; corners of the rest shape excepted by where they are.
double sharpest_joint(Outline const& outline) {
  double sharpest = 0;
  for (std::size_t i = 0; i < outline.pieces.size(); ++i) {
    auto const& in = outline.pieces[i].curve.control;
    auto const& out = outline.pieces[(i + 1) % outline.pieces.size()].curve.control;
    Vec2 const a = normalized(in[3] - in[2]);
    Vec2 const b = normalized(out[1] - out[0]);
    sharpest = larger(sharpest, std::abs(atan2_of(cross(a, b), dot(a, b))));
  }
  return sharpest;
}

TEST(OutlineRide, KeepsSmoothJointsSmooth) {
  auto const shape = face_shape(200);
  for (auto const mode : kBendModes) {
    auto const bender = made_bender(shape, mode);
    auto const bent = bender.bent(posed(bender.rest_pose(), strong_bend(shape)));
    for (auto const& outline : bent.outlines) EXPECT_LT(sharpest_joint(outline), 1e-9);
  }
}

/// How far the outline of a bar that was bent by arc_map leaves its arcs; its ends excepted.
double off_the_arcs(Outline const& outline, Vec2 centre, double inner, double outer, double angle) {
  double worst = 0;
  for (auto const& piece : outline.pieces) {
    for (int k = 0; k <= 16; ++k) {
      Vec2 const p = point_at(piece.curve, k / 16.0) - centre;
      double const at = atan2_of(p.x, -p.y);
      if (at < 0.02 || at > angle - 0.02) continue;
      worst = larger(worst, std::min(std::abs(norm(p) - inner), std::abs(norm(p) - outer)));
    }
  }
  return worst;
}

TEST(OutlineRide, BendsALongCubicIntoAnArc) {
  for (auto const mode : kBendModes) {
    auto const bender = made_bender({{bar_outline(400, 40)}, {}}, mode);
    for (double const angle : {0.3, 1.0, 2.0, 3.0}) {
      double const radius = 400 / angle;
      auto const bent = bender.bent(posed(bender.rest_pose(), arc_map(400, 20, angle)));
      EXPECT_LT(off_the_arcs(bent.outlines[0], {0, 20 + radius}, radius - 20, radius + 20, angle),
                0.03);
      EXPECT_LT(bent.outlines[0].pieces.size(), 50U) << "outlines stay light";
    }
  }
}

TEST(OutlineRide, KeepsABendThatNeitherTheWholePieceNorItsHalvesShow) {
  auto const bender = made_bender({{bar_outline(400, 40)}, {}});
  // Two humps: at both ends of each half the side lies and points as at rest.
  auto const bent = bender.bent(posed(bender.rest_pose(), [](Vec2 p) {
    double const sin = sin_cos(2 * kPi * p.x / 400).sin;
    return Vec2{p.x, p.y + 10 * sin * sin * sin * sin};
  }));
  double highest = 0;
  for (auto const& piece : bent.outlines[0].pieces) highest = larger(highest, piece.curve.end().y);
  EXPECT_NEAR(highest, 50, 0.1);
}

}  // namespace
}  // namespace inkflate
