// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "base/rng.h"
#include "deform/bender.h"
#include "geometry/trig.h"
#include "support/characters.h"

namespace inkflate {
namespace {

// What tests/tools/random_bends.cpp does with drawings, in small.
TEST(RandomDrags, TurnNoTriangleAndStayFinite) {
  Rng rng(3);
  auto const drawing = character(3);
  for (int trial = 0; trial < 6; ++trial) {
    auto bender = Bender::make({drawing.layers[rng.below(3)].outlines, {}});
    ASSERT_TRUE(bender.has_value());
    auto const& mesh = bender->mesh();
    auto const& line = mesh.lines[0].vertices;
    std::vector<BendHandle> handles;
    int const pins = 2 + rng.below(5);
    for (int i = 0; i < pins; ++i) {
      auto const place = mesh.rest.points[line[rng.below(static_cast<int>(std::ssize(line)))]];
      handles.push_back({bender->nearest(bender->rest_pose(), place), place, {}});
      // Two at one place, of which one is drawn away.
      if (i == 0 && rng.below(3) == 0) handles.push_back(handles.back());
    }
    auto const turn = sin_cos(rng.uniform(-kPi, kPi));
    double const length_px = rng.below(4) == 0 ? 5000 : 400;
    auto const from = handles.back().target;
    auto pose = bender->rest_pose();
    for (int frame = 1; frame <= 10; ++frame) {
      handles.back().target = from + Vec2{turn.cos, turn.sin} * (length_px * frame / 10);
      bender->step(pose, {handles, {}}, 2);
      for (auto const& [a, b, c] : mesh.rest.triangles) {
        double const area = cross(pose[b] - pose[a], pose[c] - pose[a]);
        ASSERT_TRUE(area > 0 && is_finite(pose[a])) << trial << " " << frame;
      }
    }
    auto const bent = bender->bent(pose);
    for (auto const& piece : bent.outlines.front().pieces) {
      for (auto const p : piece.curve.control) ASSERT_TRUE(is_finite(p));
    }
  }
}

}  // namespace
}  // namespace inkflate
