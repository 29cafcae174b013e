// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cli/picture_in.h"
#include "cli/program.h"
#include "support/golden.h"

namespace inkflate {
namespace {

/// The walk-throughs of the thesis' chapter 6, by tests/tools/make_replays.py. Each leaves a picture of the drawing and one of the model.
class Replay : public testing::TestWithParam<char const*> {};

TEST_P(Replay, LooksAsItWasApproved) {
  ScratchFolder const folder;
  std::string const name = GetParam();
  auto const path = std::string(INKFLATE_SOURCE_DIR) + "/tests/data/replay/" + name + ".jsonl";
  auto const run = run_inkflate(folder.path(), {"replay", path, "--quiet", "--files", "."});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  EXPECT_TRUE(matches_golden(picture_in(folder, "drawing.png"), "replay/" + name));
  EXPECT_TRUE(matches_golden(picture_in(folder, "model.png"), "replay/" + name + "_model"));
}

INSTANTIATE_TEST_SUITE_P(Thesis, Replay,
                         testing::Values("mouse", "alligator", "dove", "seahorse", "crab",
                                         "butterfly", "octopus", "half_torus", "torus"),
                         [](auto const& each) { return std::string(each.param); });

}  // namespace
}  // namespace inkflate
