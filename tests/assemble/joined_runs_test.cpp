// SPDX-License-Identifier: Apache-2.0
#include "assemble/joined_runs.h"

#include <gtest/gtest.h>

#include "assemble/assemble.h"
#include "support/characters.h"

namespace inkflate {
namespace {

TEST(JoinedRuns, AreTheJointsOfTheModel) {
  for (int const layers : {1, 3, 5, 9}) {
    auto const drawing = character(layers);
    auto const model = assemble(drawing);
    ASSERT_TRUE(model.has_value());
    auto const joined = joined_runs(drawing);
    ASSERT_EQ(joined.size(), model->joints.size()) << layers;
    for (std::size_t i = 0; i < joined.size(); ++i) {
      EXPECT_EQ(joined[i].limb, model->joints[i].limb);
      EXPECT_EQ(joined[i].host, model->joints[i].host);
    }
  }
}

TEST(JoinedRuns, LieWhereTheMouthWasDrawnAlsoWhereTheModelPushesItIntoItsHost) {
  // The mouth, at x = 700, stops 12 px short of the body's rim.
  auto const drawing = drawing_of({drawn_layer("body", ellipse_contour({500, 500}, 188, 250)),
                                   limb_layer("arm", {700, 500}, {900, 500}, 40)});
  auto const joined = joined_runs(drawing);
  ASSERT_EQ(joined.size(), 1);
  EXPECT_EQ(joined[0].limb, 1);
  EXPECT_EQ(joined[0].host, 0);
  for (auto const p : joined[0].points) EXPECT_NEAR(p.x, 700, 1e-9);
}

TEST(JoinedRuns, LayersWithoutOutlinesAreLeftOutAndTheOthersKeepTheirIndices) {
  auto drawing = character(3);
  drawing.layers.insert(drawing.layers.begin(), Layer{});
  auto const joined = joined_runs(drawing);
  ASSERT_EQ(joined.size(), 2);
  EXPECT_EQ(joined[0].host, 1);
  EXPECT_EQ(joined[1].limb, 3);
}

TEST(JoinedRuns, ThereAreNoneWhereThereIsNothing) {
  EXPECT_TRUE(joined_runs({}).empty());
  EXPECT_TRUE(joined_runs(drawing_of({Layer{}, Layer{}})).empty());
  auto const point = drawn_layer("point", {{5, 5}, {5, 5}, {5, 5}});
  EXPECT_TRUE(joined_runs(drawing_of({point, point})).empty());
}

}  // namespace
}  // namespace inkflate
