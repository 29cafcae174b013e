// SPDX-License-Identifier: Apache-2.0
#include "deform/bender.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rng.h"
#include "geometry/affine.h"
#include "geometry/trig.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

using namespace support;

Bender made(BendShape const& shape, BendMode mode = BendMode::Body) {
  BendOptions options;
  options.mode = mode;
  auto bender = Bender::make(shape, options);
  EXPECT_TRUE(bender) << (bender ? "" : bender.error().message);
  return std::move(*bender);
}

BendShape only_lines(std::vector<Polyline> lines) { return {{}, std::move(lines)}; }

/// One of each kind.
std::vector<BendShape> sample_shapes() {
  Polyline wave;
  for (int i = 0; i < 300; ++i) wave.push_back({i * 2.0, 40 * sin_cos(i * 0.05).sin});
  return {face_shape(200),
          {{bar_outline(400, 40)}, {}},
          {{crossing_outline(500)}, {{{250, 250}, {300, 250}}}},
          {{crossing_outline(500), disc_outline({100, 100}, 20, true)}, {}},
          {{polygon_outline({{5, 5}, {80, 5}})}, {}},
          {{polygon_outline({{5, 5}, {5, 5}})}, {{{9, 9}}}},
          {{disc_outline({1e4, 1e4}, 1e4)}, {}},
          {{disc_outline({1.5, 1.5}, 1.5)}, {}},
          // Thinner than doubles can tell, and smaller.
          {{polygon_outline({{0, 0}, {100, 1e-13}, {200, 0}, {100, 2e-13}})}, {}},
          {{disc_outline({1e6, 1e6}, 1e-8)}, {}},
          only_lines({{{1e6, 1e6}, {1e6, 1e6 + 1e-8}}}),
          // Comes back to its start again and again.
          only_lines({{{0, 0}, {50, 0}, {0, 0}, {0, 50}, {0, 0}, {50, 0}, {0, 0}}}),
          only_lines({wave, {{5, 60}, {200, 90}}, {{300, 80}}}),
          only_lines({{{3, 3}}, {{40, 3}}})};
}

std::vector<BendMode> const kModes = {BendMode::Body, BendMode::Wire};

TEST(Bender, GivesTheRestShapeInTheRestPoseToTheLastBit) {
  for (auto const mode : kModes) {
    for (auto const& shape : sample_shapes()) {
      auto const bender = made(shape, mode);
      auto const bent = bender.bent(bender.rest_pose());
      EXPECT_EQ(bent.outlines, shape.outlines);
      EXPECT_EQ(bent.lines, shape.lines);
    }
  }
}

TEST(Bender, KeepsWhatHasNotMovedToTheLastBit) {
  auto const shape = BendShape{{bar_outline(800, 40)}, {{{10, 10}, {300, 30}, {20, 55}}}};
  auto const bender = made(shape);
  auto const pose = posed(bender.rest_pose(), [](Vec2 p) {
    return p.x > 500 ? Vec2{p.x, p.y + (p.x - 500) * (p.x - 500) / 400} : p;
  });
  auto const bent = bender.bent(pose);
  EXPECT_EQ(bent.lines, shape.lines);
  auto const& pieces = bent.outlines[0].pieces;
  EXPECT_EQ(pieces.back(), shape.outlines[0].pieces.back());
  EXPECT_EQ(pieces.front().curve.start(), (Vec2{0, 0}));
  EXPECT_GT(pieces.size(), 6U);
}

TEST(Bender, KeepsBentShapesOnAGridThatNobodySees) {
  auto const move = [](Vec2 p) { return p + Vec2{p.y / 7, p.x / 9}; };
  for (auto const mode : kModes) {
    for (auto const& shape : sample_shapes()) {
      auto const bender = made(shape, mode);
      auto const rest = bender.bent_on_grid(bender.rest_pose());
      EXPECT_EQ(rest.outlines, shape.outlines);
      EXPECT_EQ(rest.lines, shape.lines);
      auto const pose = posed(bender.rest_pose(), move);
      EXPECT_LT(largest_difference(bender.bent_on_grid(pose), bender.bent(pose)), 1e-3);
    }
  }
}

TEST(Bender, MovesRigidlyInRigidPoses) {
  auto const turn = sin_cos(1.3);
  Affine const map = {turn.cos, turn.sin, -turn.sin, turn.cos, 310, -47};
  auto const move = [&](Vec2 p) { return map(p); };
  for (auto const mode : kModes) {
    for (auto const& shape : sample_shapes()) {
      auto const bender = made(shape, mode);
      auto const bent = bender.bent(posed(bender.rest_pose(), move));
      EXPECT_LT(largest_difference(bent, mapped(shape, move)), 1e-6);
    }
  }
}

TEST(Bender, IsExactInAffinePoses) {
  Affine const map = {1.4, 0.2, -0.5, 0.8, 31, 12};
  auto const move = [&](Vec2 p) { return map(p); };
  for (auto const& shape : sample_shapes()) {
    auto const bender = made(shape);
    auto const bent = bender.bent(posed(bender.rest_pose(), move));
    EXPECT_LT(largest_difference(bent, mapped(shape, move)), 1e-6);
    for (std::size_t i = 0; i < shape.outlines.size(); ++i)
      EXPECT_EQ(bent.outlines[i].sources, shape.outlines[i].sources);
  }
}

/// A strong bend of a shape in 0 .. size, the same for all of it.
std::function<Vec2(Vec2)> strong_bend(BendShape const& shape) {
  Rect box;
  for (auto const& outline : shape.outlines) {
    for (auto const& piece : outline.pieces) box.include(piece.curve.start());
  }
  return arc_map(box.width(), box.max.y * 1.5, 1.2);
}

TEST(Bender, JoinsPiecesExactlyAndKeepsKindsAndPoints) {
  auto const shape = face_shape(200);
  for (auto const mode : kModes) {
    auto const bender = made(shape, mode);
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

TEST(Bender, LeavesSourcesAtTheirPlacesOfTheOutline) {
  auto const shape = face_shape(200);
  auto const bend = strong_bend(shape);
  auto const bender = made(shape);
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
    sharpest = std::max(sharpest, std::abs(atan2_of(cross(a, b), dot(a, b))));
  }
  return sharpest;
}

TEST(Bender, KeepsSmoothJointsSmooth) {
  auto const shape = face_shape(200);
  for (auto const mode : kModes) {
    auto const bender = made(shape, mode);
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
      worst = std::max(worst, std::min(std::abs(norm(p) - inner), std::abs(norm(p) - outer)));
    }
  }
  return worst;
}

TEST(Bender, BendsALongCubicIntoAnArc) {
  for (auto const mode : kModes) {
    auto const bender = made({{bar_outline(400, 40)}, {}}, mode);
    for (double const angle : {0.3, 1.0, 2.0, 3.0}) {
      double const radius = 400 / angle;
      auto const bent = bender.bent(posed(bender.rest_pose(), arc_map(400, 20, angle)));
      EXPECT_LT(off_the_arcs(bent.outlines[0], {0, 20 + radius}, radius - 20, radius + 20, angle),
                0.03);
      EXPECT_LT(bent.outlines[0].pieces.size(), 50U) << "outlines stay light";
    }
  }
}

TEST(Bender, SaysWhatIsNearestInThePose) {
  auto const shape = face_shape(200);
  auto const bend = strong_bend(shape);
  for (auto const mode : kModes) {
    auto const bender = made(shape, mode);
    auto const pose = posed(bender.rest_pose(), bend);
    for (auto const& line : bender.mesh().lines) {
      for (int const v : line.vertices) {
        auto const anchor = bender.nearest(pose, pose[v]);
        EXPECT_LT(distance(place_of(bender.mesh().rest, pose, anchor), pose[v]), 1e-9);
      }
    }
    auto const far = bender.nearest(pose, {1e6, -1e6});
    EXPECT_TRUE(is_finite(place_of(bender.mesh().rest, pose, far)));
  }
}

TEST(Bender, FindsWhatLiesUnderAPlaceInAnyPose) {
  auto const bender = made({{bar_outline(400, 40)}, {}});
  auto pose = bender.rest_pose();
  for (auto& p : pose) p += Vec2{30, -50};
  auto const under = bender.under(pose, {230, -45});
  ASSERT_TRUE(under.has_value());
  EXPECT_LT(distance(place_of(bender.mesh().rest, pose, *under), {230, -45}), 1e-9);
  EXPECT_FALSE(bender.under(pose, {230, 45}).has_value());
}

TEST(Bender, KnowsWhatIsBeyondReach) {
  auto const bender = made({{bar_outline(400, 40)}, {}});
  auto const& rest = bender.rest_pose();
  auto const from = bender.nearest(rest, {100, 0});
  auto const beyond = bender.within_reach(from, 80).is_fixed;
  ASSERT_EQ(beyond.size(), rest.size());
  for (std::size_t v = 0; v < rest.size(); ++v)
    EXPECT_EQ(beyond[v] != 0, distance(rest[v], {100, 0}) > 80) << v;
}

TEST(Bender, BendsRounderWhereItIsStifferTowardsTheEndOfAReach) {
  auto bender = made({{bar_outline(400, 40)}, {}});
  auto const& rest = bender.rest_pose();
  auto const tip = bender.nearest(rest, {400, 0});
  auto const area = bender.within_reach(tip, 200);
  BendHandle const handle = {tip, {380, 60}};
  auto const sharpest = [&](BendHold const& hold) {
    auto pose = rest;
    bender.step(pose, hold, 60);
    // By how much the upper side turns within 10 px, at most.
    double most = 0;
    for (double x = 150; x <= 390; x += 5) {
      auto const direction = [&](double from) {
        auto const place = [&](double at) {
          return place_of(bender.mesh().rest, pose, bender.nearest(rest, {at, -20}));
        };
        return normalized(place(from + 5) - place(from));
      };
      most = std::max(most, std::abs(cross(direction(x), direction(x - 10))));
    }
    return most;
  };
  double const kinked = sharpest({{&handle, 1}, area.is_fixed, {}});
  EXPECT_LT(sharpest({{&handle, 1}, area.is_fixed, area.stiffening}), 0.8 * kinked);
}

TEST(Bender, RefusesWhatItCannotBend) {
  EXPECT_EQ(Bender::make({}).error().code, ErrorCode::NothingThere);
  EXPECT_EQ(Bender::make({{Outline{}}, {{}}}).error().code, ErrorCode::NothingThere);
  BendShape const disc = {{disc_outline({0, 0}, 5)}, {}};
  for (double const body : {0.0, 0.001, 1.1, std::nan("")}) {
    BendOptions options;
    options.body = body;
    EXPECT_EQ(Bender::make(disc, options).error().code, ErrorCode::BadOption);
  }
  BendOptions options;
  options.strip_half_width_px = -1;
  EXPECT_EQ(Bender::make(disc, options).error().code, ErrorCode::BadOption);
}

/// Drags the rightmost place of the lines upwards while the leftmost is held.
BendShape dragged(Bender& bender, double way_px, int frames) {
  auto pose = bender.rest_pose();
  std::vector<BendHandle> handles;
  for (double const x : {-1e6, 1e6}) {
    auto const anchor = bender.nearest(pose, {x, 20});
    handles.push_back({anchor, place_of(bender.mesh().rest, pose, anchor)});
  }
  Vec2 const start = handles[1].target;
  for (int i = 1; i <= frames; ++i) {
    handles[1].target = start - Vec2{0, way_px * i / frames};
    bender.step(pose, {handles, {}}, 2);
  }
  bender.step(pose, {handles, {}}, 20);
  return bender.bent(pose);
}

TEST(Bender, DragsEveryKindOfShape) {
  for (auto const mode : kModes) {
    for (auto const& shape : sample_shapes()) {
      auto bender = made(shape, mode);
      Rect const box = bounds(bender.rest_pose());
      auto const bent = dragged(bender, 0.3 * box.longer_side(), 4);
      for (auto const& outline : bent.outlines) {
        for (auto const& piece : outline.pieces) {
          for (auto const p : piece.curve.control) EXPECT_TRUE(is_finite(p));
        }
      }
      for (auto const& line : bent.lines) {
        for (auto const p : line) EXPECT_TRUE(is_finite(p));
      }
    }
  }
}

TEST(Bender, BendsAMirroredShapeToTheMirroredResult) {
  BendShape const shape = {{bar_outline(400, 40)}, {}};
  auto const mirror = [](Vec2 p) { return Vec2{p.x, 40 - p.y}; };
  auto mirrored = mapped(shape, mirror);
  std::reverse(mirrored.outlines[0].pieces.begin(), mirrored.outlines[0].pieces.end());
  for (auto& piece : mirrored.outlines[0].pieces)
    std::reverse(piece.curve.control.begin(), piece.curve.control.end());
  auto up = made(shape);
  auto down = made(mirrored);
  auto const bent_up = flatten(dragged(up, 120, 10).outlines[0], 0.01);
  auto const bent_down = flatten(dragged(down, -120, 10).outlines[0], 0.01);
  // The meshes inside are not each other's mirror images.
  for (auto const p : bent_up) {
    double nearest = 1e300;
    for (std::size_t i = 0; i < bent_down.size(); ++i)
      nearest =
          std::min(nearest, squared_distance_to_segment(mirror(p), bent_down[i],
                                                        bent_down[(i + 1) % bent_down.size()]));
    EXPECT_LT(std::sqrt(nearest), 2);
  }
}

}  // namespace
}  // namespace inkflate
